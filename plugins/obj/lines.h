#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace candela_obj {

/// The lines of an OBJ or MTL file that say something. Lines that a backslash at their end continues are
/// joined; empty lines and comments are left out, and so are the blanks around a line.
class Lines {
  public:
    explicit Lines(std::string_view text);

    /// Goes to the next line; false at the end of the text.
    bool next();
    /// Valid until `next`.
    std::string_view line() const { return line_; }
    /// Of the line's beginning, from 1.
    std::size_t number() const { return number_; }
    /// The bytes read so far.
    std::size_t position() const { return position_; }

  private:
    std::string_view physicalLine();
    void joinContinued(std::string_view first);

    std::string_view text_, line_;
    std::string joined_;
    std::size_t position_ = 0, linesRead_ = 0, number_ = 0;
};

/// Without the blanks at both ends. A carriage return is a blank.
std::string_view trimmed(std::string_view text);

bool isBlank(char c);

}  // namespace candela_obj
