#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace candela_obj {

/// Names, each kept once, in the order in which they come.
class Names {
  public:
    std::uint32_t indexOf(std::string_view name) {
        const auto [found, isNew] =
            indices_.try_emplace(std::string(name), static_cast<std::uint32_t>(names_.size()));
        if (isNew) names_.emplace_back(name);
        return found->second;
    }
    const std::string& operator[](std::size_t index) const { return names_[index]; }
    std::size_t size() const { return names_.size(); }

  private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, std::uint32_t> indices_;
};

}  // namespace candela_obj
