#include <candela/error.h>

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Error, namesTheFileBeforeTheText) {
    const Error error(ErrorKind::badInput, "a/b.gltf", "mesh 3 has no positions");
    EXPECT_STREQ(error.what(), "a/b.gltf: mesh 3 has no positions");
    EXPECT_EQ(error.path(), "a/b.gltf");
    EXPECT_EQ(error.kind(), ErrorKind::badInput);
}

TEST(Error, hasOnlyTheTextWithoutAFile) {
    const Error error(ErrorKind::environment, "", "no OpenGL 4.5");
    EXPECT_STREQ(error.what(), "no OpenGL 4.5");
}

}  // namespace
}  // namespace candela
