#include <algorithm>
#include <numeric>
#include <string_view>

#include "io/benchmark/table/report_text.hpp"
#include "io/text/escape.hpp"

namespace asv::io {

namespace {

/// The letter as LaTeX shows it, in any font encoding.
std::string shown(char letter) {
    switch (letter) {
        case '\\':
            return "\\textbackslash{}";
        case '^':
            return "\\textasciicircum{}";
        case '~':
            return "\\textasciitilde{}";
        case '<':
            return "\\textless{}";
        case '>':
            return "\\textgreater{}";
        case '|':
            return "\\textbar{}";
        case '"':
            return "\\char34{}";
        // The one of text comes from a font that small installations have as pixels alone.
        case '$':
            return "\\ensuremath{\\mathdollar}";
        case '{':
        case '}':
        case '&':
        case '#':
        case '_':
        case '%':
            return std::string("\\") + letter;
        // A bracket or a star behind the end of a row would be an argument; two quotes or
        // backquotes would become another letter.
        case '[':
        case ']':
        case '*':
        case '\'':
        case '`':
            return std::string("{") + letter + "}";
        default:
            return {letter};
    }
}

std::string latex_words(std::string_view words) {
    std::string text;
    for (const char letter : escaped(words)) {
        if (letter == '-' && text.ends_with('-')) text += "{}";  // two would become a longer dash
        text += shown(letter);
    }
    return text;
}

/// Nothing in it ends the line.
std::string comment(std::string_view words) {
    return "% " + escaped(words) + "\n";
}

// In letters of small size, of which a line of LaTeX's own article has that many; the space between
// two columns takes two, and so does a sign of inequality.
constexpr std::size_t letters_in_line = 76, letters_between = 2;
/// Longer words are broken into lines of this many letters, which is 9em wide.
constexpr std::size_t letters_in_cell = 20;

bool is_broken(std::string_view cell, bool has_words) {
    return has_words && cell.size() > letters_in_cell;
}

/// Words that are too long for one line of a cell: in several, also where there is no blank.
std::string broken_words(std::string_view cell) {
    std::string text = "\\parbox[t]{9em}{\\raggedright ";
    for (const std::string_view breakable = "_/=.,:"; !cell.empty();) {
        const std::size_t end = std::min(cell.find_first_of(breakable), cell.size() - 1) + 1;
        text += latex_words(cell.substr(0, end)) + "\\allowbreak{}";
        cell.remove_prefix(end);
    }
    return text + "\\strut}";
}

/// Columns of one tabular, by their places in the table.
using Part = std::vector<std::size_t>;

std::size_t letters_of(std::string_view cell) {
    return cell.size() + static_cast<std::size_t>(std::count(cell.begin(), cell.end(), '>'));
}

std::size_t letters_of(const TextTable& table, std::size_t column) {
    std::size_t most = letters_of(table.heads[column]);
    for (const std::vector<std::string>& row : table.rows)
        most = std::max(most, is_broken(row[column], column < table.word_columns)
                                  ? letters_in_cell
                                  : letters_of(row[column]));
    return most + letters_between;
}

/// As many columns in each as the line has room for, behind those of words, which all have.
std::vector<Part> parts_of(const TextTable& table) {
    Part words(table.word_columns);
    std::iota(words.begin(), words.end(), std::size_t{0});
    std::size_t taken_by_words = 0;
    for (const std::size_t column : words) taken_by_words += letters_of(table, column);

    std::vector<Part> parts{words};
    std::size_t taken = taken_by_words;
    for (std::size_t column = table.word_columns; column < table.heads.size(); ++column) {
        const std::size_t letters = letters_of(table, column);
        if (taken + letters > letters_in_line && parts.back().size() > words.size()) {
            parts.push_back(words);
            taken = taken_by_words;
        }
        parts.back().push_back(column);
        taken += letters;
    }
    return parts;
}

std::string latex_row(const TextTable& table, const std::vector<std::string>& cells,
                      const Part& part) {
    std::string text;
    for (const std::size_t column : part) {
        const std::string& cell = cells[column];
        text += text.empty() ? "  " : " & ";
        text +=
            is_broken(cell, column < table.word_columns) ? broken_words(cell) : latex_words(cell);
    }
    return text + " \\\\\n";
}

std::string caption(const TextTable& table, const std::string& spoilt) {
    std::string text = table.title + (table.facts.empty() ? "." : ": " + table.facts);
    if (!spoilt.empty()) text += " " + spoilt;
    return latex_words(text);
}

std::string tabular(const TextTable& table, const Part& part) {
    const std::string alignment =
        std::string(table.word_columns, 'l') + std::string(part.size() - table.word_columns, 'r');
    std::string text = "\\begin{tabular}{" + alignment + "}\n\\toprule\n" +
                       latex_row(table, table.heads, part) + "\\midrule\n";
    for (const std::vector<std::string>& row : table.rows) text += latex_row(table, row, part);
    return text + "\\bottomrule\n\\end{tabular}\n";
}

/// One below the other, what does not stand beside.
std::string float_of(const TextTable& table, const std::string& spoilt) {
    std::string text =
        "\n\\begin{table}\n\\centering\n\\setlength{\\belowcaptionskip}{6pt}\n\\caption{" +
        caption(table, spoilt) + "}\n\\small\n\\setlength{\\tabcolsep}{4pt}\n";
    bool first = true;
    for (const Part& part : parts_of(table)) {
        if (!first) text += "\\par\\medskip\n";
        text += tabular(table, part);
        first = false;
    }
    return text + "\\end{table}\n";
}

}  // namespace

std::string latex(const ReportText& report) {
    std::string text = comment("Needs \\usepackage{booktabs}.");
    for (const std::string& note : report.notes) text += comment(note);
    for (const std::string& entry : report.unsolved) text += comment("Not solved: " + entry);
    for (const TextTable& table : report.tables) text += float_of(table, report.spoilt);
    return text;
}

}  // namespace asv::io
