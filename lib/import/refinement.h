#pragma once

#include "import/plugin_file.h"

#include <candela/cage.h>
#include <candela/plugin.h>
#include <candela/refined_cage.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

class ThreadPool;

/// The struct of a cage for a subdivider, without influences, morph targets and materials. Refers to the
/// `Cage`, which must live as long.
class CageStruct {
  public:
    /// Throws `Error` (limit) when a count of the cage does not fit 32 bits.
    explicit CageStruct(const Cage& cage);
    CageStruct(const CageStruct&) = delete;
    CageStruct& operator=(const CageStruct&) = delete;

    const candela_cage& get() const { return struct_; }

  private:
    void setRules(const Cage& cage);
    void setFaces(const Cage& cage);
    void setSharpness(const Cage& cage);

    std::vector<std::uint32_t> creaseEdges_, cornerVertices_;
    std::vector<float> creaseSharpness_, cornerSharpness_;
    candela_cage struct_{};
};

/// One call of a plugin's subdivider: implements `candela_refinement`. It checks and copies the result that
/// the plugin sets, and keeps the first failure.
class Refinement {
  public:
    /// `plugin` offers a subdivider. All arguments must live as long as this does.
    Refinement(const LoadedPlugin& plugin, const Cage& cage, const candela_cage& cageStruct);

    /// Calls the plugin. Throws `Error` as `Subdivider::refine` says.
    RefinedCage run(std::uint32_t level);

  private:
    struct Functions;

    template <class Action>
    bool guarded(Action action) noexcept;
    void call(std::uint32_t level);
    void setResult(const candela_refined_cage* result);
    [[noreturn]] void refuse(const std::string& text) const;
    [[noreturn]] void failForPlugin(const char* how) const;

    const LoadedPlugin& plugin_;
    const Cage& cage_;
    const candela_cage& cageStruct_;
    std::optional<RefinedCage> refined_;
    std::exception_ptr failure_;
    std::shared_ptr<ThreadPool> pool_;
};

}  // namespace candela
