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
        case '{':
        case '}':
        case '$':
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

std::string latex_row(const std::vector<std::string>& cells) {
    std::string text;
    for (const std::string& cell : cells) text += (text.empty() ? "  " : " & ") + latex_words(cell);
    return text + " \\\\\n";
}

std::string caption(const TextTable& table, const std::string& spoilt) {
    std::string text = table.title + (table.facts.empty() ? "." : ": " + table.facts);
    if (!spoilt.empty()) text += " " + spoilt;
    return latex_words(text);
}

std::string tabular(const TextTable& table, const std::string& spoilt) {
    const std::string alignment = std::string(table.word_columns, 'l') +
                                  std::string(table.heads.size() - table.word_columns, 'r');
    std::string text = "\n\\begin{table}\n\\centering\n\\caption{" + caption(table, spoilt) +
                       "}\n\\begin{tabular}{" + alignment + "}\n\\toprule\n" +
                       latex_row(table.heads) + "\\midrule\n";
    for (const std::vector<std::string>& row : table.rows) text += latex_row(row);
    return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

}  // namespace

std::string latex(const ReportText& report) {
    std::string text = comment("Needs \\usepackage{booktabs}.");
    for (const std::string& note : report.notes) text += comment(note);
    for (const std::string& entry : report.unsolved) text += comment("Not solved: " + entry);
    for (const TextTable& table : report.tables) text += tabular(table, report.spoilt);
    return text;
}

}  // namespace asv::io
