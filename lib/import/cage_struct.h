#pragma once

#include <candela/cage.h>
#include <candela/plugin.h>

#include <cstdint>
#include <vector>

namespace candela {

/// A cage as a subdivider sees it. Refers to the `Cage`, which must live as long; what moves the cage and its
/// materials are left out.
class CageStruct {
  public:
    /// Throws `Error` (limit) when the cage has more of something than 32 bits can count.
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

}  // namespace candela
