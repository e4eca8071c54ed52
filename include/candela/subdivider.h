#pragma once

#include <candela/cage.h>
#include <candela/export.h>
#include <candela/refined_cage.h>

#include <cstdint>
#include <memory>
#include <string>

namespace candela {

/// A plugin's service that refines cages (`PluginRegistry::subdivider`). A cheap handle; copies share, and
/// keep the plugin loaded.
class CANDELA_API Subdivider {
  public:
    /// The plugin's name. Throws `Error` (badInput) when this was moved from.
    const std::string& name() const;

    /// Refines a cage to `level`, 1 to `maxSubdivisionLevel`. The result has been checked: sizes, indices,
    /// finite weights. May be called from several threads at once. Throws `Error`: badInput when the level is
    /// out of range, when the cage breaks a rule of `validate` (materials are not looked at) or the plugin
    /// rejects it, naming the cage and its face, edge or vertex; limit when memory or 32-bit indices do not
    /// hold the result. A subdivider that was moved from throws badInput.
    RefinedCage refine(const Cage& cage, std::uint32_t level) const;

    struct State;  ///< Private to the library.
    explicit Subdivider(std::shared_ptr<const State> state);

  private:
    const State& state() const;

    std::shared_ptr<const State> state_;
};

}  // namespace candela
