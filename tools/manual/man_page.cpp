#include <cctype>
#include <sstream>

#include "core/solve/planner_catalogue.hpp"
#include "tools/manual/command.hpp"
#include "tools/manual/manual.hpp"
#include "tools/manual/text_pieces.hpp"

namespace asv::tools::manual {

namespace {

/// The day when what stands in words.cpp was last changed; manual pages have one.
constexpr const char* date = "2026-11-26";

/// Text as roff takes it: a backslash and a dash are written out, and a line must not begin with a
/// dot or a quote.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    if (!result.empty() && (result[0] == '.' || result[0] == '\'')) result.insert(0, "\\&");
    return result;
}

/// Text in lines of at most 80 characters, as man pages are wanted; they are filled anew when
/// shown.
std::string folded(std::string_view text) {
    constexpr std::size_t width = 80;
    std::istringstream words{std::string(text)};
    std::string result, line;
    for (std::string word; words >> word;) {
        const std::string longer = line.empty() ? word : line + ' ' + word;
        if (escaped(longer).size() <= width) {
            line = longer;
            continue;
        }
        result += escaped(line) + '\n';
        line = word;
    }
    return result + escaped(line);
}

std::string bold(std::string_view text) {
    return glued({"\\fB", escaped(text), "\\fR"});
}
std::string italic(std::string_view text) {
    return glued({"\\fI", escaped(text), "\\fR"});
}

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// A sentence for the reader of a page: --help and the catalogue have no full stops.
std::string sentence(std::string text) {
    if (text.empty()) return text;
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    if (text.back() != '.') text += '.';
    return text;
}

class Page {
  public:
    void section(const std::string& title) { out_ << ".SH " << title << '\n'; }
    void subsection(const std::string& title) { out_ << ".SS " << escaped(title) << '\n'; }
    void text(const std::string& line) { out_ << folded(line) << '\n'; }
    void paragraph(const std::string& line) { out_ << ".PP\n" << folded(line) << '\n'; }
    /// term is roff already.
    void item(const std::string& term, const std::string& line) {
        out_ << ".TP\n" << term << '\n' << folded(line) << '\n';
    }
    void raw(const std::string& line) { out_ << line << '\n'; }
    std::string finish() const { return out_.str(); }

  private:
    std::ostringstream out_;
};

void write_synopsis(Page& page, const Command& command) {
    page.section("SYNOPSIS");
    std::string line = bold(command.name);
    for (const Argument& argument : command.options)
        if (argument.required)
            line += glued({" ", bold(argument.names.front()), " ", italic(argument.value.shown)});
    for (const Argument& argument : command.positionals) {
        const std::string name =
            italic(argument.names.front()) + (argument.repeatable ? "..." : "");
        line += argument.required ? glued({" ", name}) : glued({" [", name, "]"});
    }
    line += glued({" [", italic("OPTION"), "]..."});
    if (!command.subcommands.empty())
        line += glued({" ", italic("FAMILY"), " [", italic("OPTION"), "]..."});
    page.raw(line);
}

void write_argument(Page& page, const Argument& argument) {
    const bool positional = argument.names.front()[0] != '-';
    std::string term;
    for (const std::string& name : argument.names)
        term += (term.empty() ? "" : ", ") + (positional ? italic(name) : bold(name));
    if (!positional && !argument.value.shown.empty())
        term += glued({" ", italic(argument.value.shown)});
    std::string text = sentence(argument.description);
    if (!argument.default_value.empty()) text += " Default: " + argument.default_value + ".";
    page.item(term, text);
}

void write_options(Page& page, const Command& command) {
    page.section("OPTIONS");
    for (const Argument& argument : command.positionals) write_argument(page, argument);
    for (const Argument& argument : command.options) write_argument(page, argument);
    if (command.subcommands.empty()) return;
    page.section("FAMILIES");
    for (const Command& family : command.subcommands) {
        page.subsection(family.name);
        page.text(sentence(family.description));
        for (const Argument& argument : family.options) write_argument(page, argument);
    }
}

void write_settings(Page& page, const std::vector<core::Setting>& settings) {
    for (const core::Setting& setting : settings)
        page.item(bold(setting.name), setting.meaning + " (" + core::describe_range(setting) +
                                          "). Default: " + core::describe_value(setting) +
                                          ". Source: " + setting.source + ".");
}

/// What --planner and --set may be.
void write_planners(Page& page) {
    page.section("PLANNERS");
    page.text(
        "The settings of each are given by --set. Samplers have settings of their own, which every "
        "planner but auto takes; they stand at the end.");
    for (const auto name : core::planner_names()) {
        core::Planner planner = core::planner_named(name);
        auto settings = core::settings(planner);
        page.subsection(std::string(name));
        page.text(sentence(std::string(core::planner_summary(name))) +
                  " Source: " + std::string(core::planner_source(name)) + ".");
        if (core::sampler_options(planner)) {
            core::SamplerOptions sampler;
            const auto of_sampler = std::ranges::find(settings, "sampler", &core::Setting::name);
            page.text("Its sampler is " + core::describe_value(*of_sampler) + " by default.");
            settings.resize(settings.size() - settings_of(sampler).size());
        }
        write_settings(page, settings);
    }
    page.subsection("Samplers");
    core::SamplerOptions sampler;
    page.text("Where planners take their samples from.");
    write_settings(page, settings_of(sampler));
}

void write_see_also(Page& page, const Command& command) {
    page.section("SEE ALSO");
    std::string line;
    for (const char* name : {"asv-bench", "asv-generate", "asv-solve", "asv-validate", "asv-view"})
        if (command.name != name) line += (line.empty() ? "" : ",\n") + bold(name) + "(1)";
    page.raw(line);
}

}  // namespace

std::string man_page(const Command& command, std::string_view version,
                     std::span<const Entry> exit_codes) {
    const Words words = words_of(command.name);
    Page page;
    page.raw(".\\\" Made from the options of " + command.name + ", as --help prints them.");
    page.raw(".TH " + upper(command.name) + " 1 " + date + " \"asv " + std::string(version) +
             "\" \"User Commands\"");
    page.section("NAME");
    page.raw(escaped(command.name) + " \\- " + escaped(words.purpose));
    write_synopsis(page, command);
    page.section("DESCRIPTION");
    page.text(command.description);
    for (const std::string& paragraph : words.paragraphs) page.paragraph(paragraph);
    write_options(page, command);
    if (takes(command, Value::Kind::setting)) write_planners(page);
    page.section("EXIT STATUS");
    for (const Entry& code : exit_codes) page.item(bold(code.term), sentence(code.text));
    page.section("ENVIRONMENT");
    for (const Entry& variable : environment_of_all())
        page.item(bold(variable.term), variable.text);
    page.section("FILES");
    for (const Entry& file : words.files) page.item(italic(file.term), file.text);
    page.section("EXAMPLES");
    for (const Entry& example : words.examples) page.item(bold(example.term), example.text);
    write_see_also(page, command);
    return page.finish();
}

}  // namespace asv::tools::manual
