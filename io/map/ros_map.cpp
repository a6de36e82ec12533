#include "io/map/ros_map.hpp"

#include <charconv>
#include <map>
#include <new>

#include <yaml.h>

#include "io/text/json/place.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {

namespace {

constexpr double white = 255;
/// Whole greys that lie on a threshold are told from those beyond it, whatever rounding does.
constexpr double between_greys = 1e-6;
constexpr double smallest_resolution = 1e-70;

/// Libyaml counts lines and columns from 0, and takes the end for a line of its own.
TextPlace place_of(const yaml_mark_t& mark, const TextPlace& end) {
    return mark.line < end.line ? TextPlace{mark.line + 1, mark.column + 1} : end;
}

/// A YAML document as libyaml reads it; what it holds is given back on every way out.
class YamlDocument {
  public:
    YamlDocument(std::string_view content, const std::string& name) {
        if (yaml_parser_initialize(&parser_) == 0) throw std::bad_alloc();
        const auto* bytes = reinterpret_cast<const unsigned char*>(content.data());
        yaml_parser_set_input_string(&parser_, bytes, content.size());
        if (yaml_parser_load(&parser_, &document_) == 1) return;
        const bool no_memory = parser_.error == YAML_MEMORY_ERROR;
        const yaml_mark_t mark = parser_.problem_mark;
        const std::string problem = parser_.problem == nullptr ? "no YAML" : parser_.problem;
        yaml_parser_delete(&parser_);
        if (no_memory) throw std::bad_alloc();
        const TextPlace place = place_of(mark, place_of_offset(content, content.size()));
        throw ParseError(name, place.line, place.column, "YAML", problem);
    }
    ~YamlDocument() {
        yaml_document_delete(&document_);
        yaml_parser_delete(&parser_);
    }
    YamlDocument(const YamlDocument&) = delete;
    YamlDocument& operator=(const YamlDocument&) = delete;

    /// None where the document is empty.
    const yaml_node_t* root() { return yaml_document_get_root_node(&document_); }
    const yaml_node_t* node(int number) { return yaml_document_get_node(&document_, number); }

  private:
    yaml_parser_t parser_{};
    yaml_document_t document_{};
};

bool is_scalar(const yaml_node_t& node) {
    return node.type == YAML_SCALAR_NODE;
}

std::string text_of(const yaml_node_t& node) {
    return {reinterpret_cast<const char*>(node.data.scalar.value), node.data.scalar.length};
}

class RosMapReader {
  public:
    RosMapReader(std::string_view content, const std::string& name)
        : document_(content, name), name_(name), end_(place_of_offset(content, content.size())) {
        const yaml_node_t* root = document_.root();
        if (root == nullptr || root->type != YAML_MAPPING_NODE)
            throw ParseError(name, 1, 1, "names and values, as in 'resolution: 0.05'",
                             "something else");
        const auto& pairs = root->data.mapping.pairs;
        for (const yaml_node_pair_t* pair = pairs.start; pair != pairs.top; ++pair)
            take(*document_.node(pair->key), *document_.node(pair->value));
    }

    RosMap read() {
        RosMap map;
        const yaml_node_t& image = value("image");
        if (is_scalar(image)) map.image = text_of(image);
        if (map.image.empty() || map.image.find('\0') != std::string::npos)
            fail(image, "the name of a picture");
        map.resolution = number(value("resolution"), smallest_resolution, largest_number,
                                "the side of a pixel, above 0");
        map.origin = read_origin(value("origin"));
        map.negated = read_negate(value("negate"));
        map.occupied_thresh = number(value("occupied_thresh"), 0, 1, "a number from 0 to 1");
        map.free_thresh = number(value("free_thresh"), 0, map.occupied_thresh,
                                 "a number from 0 to occupied_thresh");
        if (values_.contains("mode")) require_mode(value("mode"));
        for (const auto& [key, node] : values_) {
            const TextPlace place = place_of(node->start_mark, end_);
            map.warnings.push_back(
                {name_, place.line, place.column, "'" + key + "' is passed over"});
        }
        return map;
    }

  private:
    [[noreturn]] void fail(const yaml_node_t& at, const std::string& expected) const {
        const TextPlace place = place_of(at.start_mark, end_);
        throw ParseError(name_, place.line, place.column, expected,
                         is_scalar(at) ? "'" + text_of(at) + "'" : "a list or names");
    }

    void take(const yaml_node_t& key, const yaml_node_t& node) {
        if (!is_scalar(key)) fail(key, "a name");
        if (!values_.insert({text_of(key), &node}).second) fail(key, "each name once");
    }

    /// The value of that name, which is not passed over then.
    const yaml_node_t& value(const std::string& key) {
        const auto found = values_.find(key);
        if (found == values_.end())
            throw ParseError(name_, end_.line, end_.column, "a line '" + key + ": ...'", "none");
        return *values_.extract(found).mapped();
    }

    double number(const yaml_node_t& node, double low, double high,
                  const std::string& expected) const {
        if (!is_scalar(node)) fail(node, expected);
        const std::string text = text_of(node);
        double result = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
        if (error != std::errc{} || end != text.data() + text.size() || !(result >= low) ||
            result > high)
            fail(node, expected);
        return result;
    }

    geometry::Point read_origin(const yaml_node_t& node) {
        const std::string expected = "[x, y, angle] of the lower left corner";
        if (node.type != YAML_SEQUENCE_NODE) fail(node, expected);
        const auto& items = node.data.sequence.items;
        if (items.top - items.start != 3) fail(node, expected);
        const auto item = [&](int i) -> const yaml_node_t& {
            return *document_.node(items.start[i]);
        };
        number(item(2), 0, 0, "the angle 0, since obstacles are not turned");
        return {number(item(0), -largest_number, largest_number, "a coordinate"),
                number(item(1), -largest_number, largest_number, "a coordinate")};
    }

    bool read_negate(const yaml_node_t& node) const {
        const std::string text = is_scalar(node) ? text_of(node) : "";
        if (text != "0" && text != "1" && text != "false" && text != "true")
            fail(node, "0 or 1, false or true");
        return text == "1" || text == "true";
    }

    /// trinary and scale differ in cells that are unknown here.
    void require_mode(const yaml_node_t& node) const {
        const std::string text = is_scalar(node) ? text_of(node) : "";
        if (text != "trinary" && text != "scale")
            fail(node, "'trinary' or 'scale' ('raw' has no thresholds)");
    }

    YamlDocument document_;
    const std::string& name_;
    TextPlace end_;
    std::map<std::string, const yaml_node_t*> values_;
};

}  // namespace

OccupiedGreys RosMap::occupied(bool unknown) const {
    const double least =
        unknown ? white * free_thresh - between_greys : white * occupied_thresh + between_greys;
    return negated ? OccupiedGreys{least, white} : OccupiedGreys{0, white - least};
}

RosMap parse_ros_map(std::string_view content, const std::string& name) {
    return RosMapReader(content, name).read();
}

}  // namespace asv::io
