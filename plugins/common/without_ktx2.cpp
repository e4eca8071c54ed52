#include "image.h"

// In place of ktx2_decoder.cpp where the library is built without Basis Universal.

namespace candela_plugins {

std::uint64_t decodedKtx2Size(const Bytes&) {
    return 0;
}

Image decodeKtx2(const Bytes&, const std::string& element) {
    throw Failure{element, "a KTX2 file, which this build does not read (CMake option CANDELA_KTX2)"};
}

}  // namespace candela_plugins
