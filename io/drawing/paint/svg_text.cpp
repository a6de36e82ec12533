#include "io/drawing/paint/svg_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "io/text/markup.hpp"
#include "io/text/valid_text.hpp"

namespace asv::io {

namespace {

/// The fonts that cairo's sans-serif is on most systems and that are on most others: one as wide as
/// the other, so that words take the room that was measured for them. Narrower ones take less.
constexpr std::string_view fonts = "'DejaVu Sans',Verdana,sans-serif";

/// As #rrggbb.
std::string hex(const Colour& colour) {
    const auto byte = [](double share) { return static_cast<unsigned>(std::lround(255 * share)); };
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(colour.red), byte(colour.green),
                  byte(colour.blue));
    return text.data();
}

std::string attribute(std::string_view name, std::string_view value) {
    std::string text = " ";
    return text.append(name).append("=\"").append(value).append("\"");
}

std::string attribute(std::string_view name, double value) {
    return attribute(name, with_two_decimals(std::to_string(value)));
}

}  // namespace

std::string svg_text(const geometry::Point& at, std::string_view words, const TextStyle& style) {
    std::string text = "<text";
    text += attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", style.size) +
            attribute("fill", hex(style.colour));
    if (style.colour.alpha < 1) text += attribute("fill-opacity", style.colour.alpha);
    if (style.bold) text += attribute("font-weight", "bold");
    if (style.align == Align::centre) text += attribute("text-anchor", "middle");
    if (style.align == Align::right) text += attribute("text-anchor", "end");
    return text + ">" + escape_markup(valid_text(words)) + "</text>\n";
}

void add_svg_texts(std::string& svg, std::string_view texts) {
    if (texts.empty()) return;
    std::string group = "<g";
    group += attribute("font-family", fonts);
    group.append(">\n").append(texts).append("</g>\n");
    const std::size_t end = svg.rfind("</svg>");
    if (end != std::string::npos) svg.insert(end, group);
}

void describe_svg(std::string& svg, std::string_view title, std::string_view description) {
    const std::size_t root = svg.find("<svg ");
    if (root == std::string::npos) return;
    svg.insert(svg.find('>', root) + 1, "\n<title>" + escape_markup(valid_text(title)) +
                                            "</title>\n<desc>" +
                                            escape_markup(valid_text(description)) + "</desc>");
    svg.insert(root + 5, "role=\"img\" ");
}

}  // namespace asv::io
