#include <cctype>
#include <string_view>

#include "io/benchmark/table/report_text.hpp"
#include "io/text/escape.hpp"

namespace asv::io {

namespace {

/// What would end a cell, or begin a tag, a link, a picture or code, is written in another way.
std::string markdown_words(std::string_view words) {
    constexpr std::string_view with_meaning = "|\\[]`";
    const std::string text = escaped(words);
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        // A bar is escaped by a backslash, which therefore must not stand alone.
        if (with_meaning.find(text[i]) != std::string_view::npos) result += '\\';
        // No tag begins with a digit: "<0.0001" stays as it is.
        const bool digit_follows =
            i + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0;
        if (text[i] == '<' && !digit_follows)
            result += "&lt;";
        else
            result += text[i];
    }
    return result;
}

std::string markdown_row(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells)
        text.append(" ").append(markdown_words(cell)).append(" |");
    return text + "\n";
}

std::string table(const TextTable& table) {
    std::string text = "\n### " + markdown_words(table.title) + "\n\n";
    if (!table.facts.empty()) text += markdown_words(table.facts) + "\n\n";
    text += markdown_row(table.heads) + "|";
    for (std::size_t i = 0; i < table.heads.size(); ++i)
        text += i < table.word_columns ? "---|" : "---:|";
    text += "\n";
    for (const std::vector<std::string>& row : table.rows) text += markdown_row(row);
    return text;
}

}  // namespace

std::string markdown(const ReportText& report) {
    std::string text;
    for (const std::string& note : report.notes)
        text.append(text.empty() ? "" : "\n").append(markdown_words(note)).append("\n");
    for (const TextTable& one : report.tables) text += table(one);
    if (!report.unsolved.empty()) text += "\nNot solved:\n\n";
    for (const std::string& entry : report.unsolved)
        text.append("- ").append(markdown_words(entry)).append("\n");
    return text;
}

}  // namespace asv::io
