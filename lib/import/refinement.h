#pragma once

#include "import/plugin_file.h"

#include <candela/cage.h>
#include <candela/plugin.h>
#include <candela/refined_cage.h>

#include <cstdint>
#include <exception>
#include <optional>
#include <string>

namespace candela {

/// One call of a plugin's subdivider: what stands behind `candela_refinement`. It checks and copies what the
/// plugin delivers, and keeps the first thing that goes wrong.
class Refinement {
  public:
    /// `plugin` offers a subdivider. All of them must live as long as this does.
    Refinement(const LoadedPlugin& plugin, const Cage& cage, const candela_cage& cageStruct);

    /// Calls the plugin. Throws `Error` as `Subdivider::refine` says.
    RefinedCage run(std::uint32_t level);

  private:
    struct Functions;

    template <class Action>
    bool guarded(Action action) noexcept;
    void call(std::uint32_t level);
    void take(const candela_refined_cage* delivered);
    [[noreturn]] void refuse(const std::string& text) const;
    [[noreturn]] void blamePlugin(const char* how) const;

    const LoadedPlugin& plugin_;
    const Cage& cage_;
    const candela_cage& cageStruct_;
    std::optional<RefinedCage> refined_;
    std::exception_ptr failure_;
};

}  // namespace candela
