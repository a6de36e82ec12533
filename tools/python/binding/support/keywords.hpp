#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

namespace asv::python {

namespace py = pybind11;

/// The keyword arguments of a call, taken one by one into the fields of an options struct.
class Keywords {
  public:
    explicit Keywords(py::dict given) : given_(std::move(given)) {}

    /// The field keeps its default where the keyword is not given. Throws TypeError for a value of
    /// another type.
    template <class Field>
    void take(const char* name, Field& field) {
        known_.emplace_back(name);
        if (!given_.contains(name)) return;
        ++used_;
        try {
            field = given_[name].cast<Field>();
        } catch (const py::cast_error&) {
            throw py::type_error(std::string(name) + ": " + std::string(py::repr(given_[name])) +
                                 " is of the wrong type");
        }
    }

    /// The same for one that is None or a number.
    template <class Field>
    void take(const char* name, std::optional<Field>& field) {
        Field value{};
        const std::size_t before = used_;
        if (given_.contains(name) && given_[name].is_none()) {
            known_.emplace_back(name);
            ++used_;
            return;
        }
        take(name, value);
        if (used_ != before) field = value;
    }

    /// The same for one of some words. Throws std::invalid_argument for another one.
    template <class Enum>
    void take_word(const char* name, Enum& field,
                   const std::vector<std::pair<const char*, Enum>>& words) {
        std::string word;
        const std::size_t before = used_;
        take(name, word);
        if (used_ == before) return;
        std::string known;
        for (const auto& [text, value] : words) {
            if (word == text) {
                field = value;
                return;
            }
            known += (known.empty() ? "" : ", ") + std::string(text);
        }
        throw std::invalid_argument(std::string(name) + ": expected one of " + known + ", not '" +
                                    word + "'");
    }

    /// Throws TypeError where a keyword was given that nobody took.
    void finish() const {
        if (used_ == given_.size()) return;
        std::string names;
        for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
        for (const auto& [key, value] : given_) {
            const auto given = key.cast<std::string>();
            bool taken = false;
            for (const std::string& name : known_) taken = taken || name == given;
            if (!taken)
                throw py::type_error("there is no option '" + given + "'; there are: " + names);
        }
    }

    const std::vector<std::string>& known() const { return known_; }

  private:
    py::dict given_;
    std::vector<std::string> known_;
    std::size_t used_ = 0;
};

}  // namespace asv::python
