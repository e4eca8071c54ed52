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
    /// The plugin's name.
    const std::string& name() const;

    /// Refines a cage that has passed `validate` to `level` (1 to `maxSubdivisionLevel`). What comes
    /// back has been checked: sizes, indices, finite weights. May be called from several threads at once.
    /// Throws `Error`: badInput that names the cage and its face, edge or vertex when the plugin rejects it;
    /// limit when memory or 32-bit indices do not hold the result.
    RefinedCage refine(const Cage& cage, std::uint32_t level) const;

    struct State;  ///< Private to the library.
    explicit Subdivider(std::shared_ptr<const State> state);

  private:
    std::shared_ptr<const State> state_;
};

}  // namespace candela
