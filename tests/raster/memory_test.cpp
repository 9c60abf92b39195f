#include "raster/memory.h"

#include <gmock/gmock.h>

#include "base/expect_error.h"

namespace inkedge::raster {
namespace {

TEST(Memory, isAskedForBeforeALargePictureIsDrawn) {
    ASSERT_TRUE(availableMemory());
    EXPECT_GT(*availableMemory(), std::uint64_t{1} << 20U);
    EXPECT_NO_THROW(expectMemory({32768, 1}, 1));
    EXPECT_NO_THROW(expectMemory({16384, 16384}, *availableMemory() >> 30U));  // a quarter of it
    expectError(
        Error::Kind::Runtime,
        testing::MatchesRegex("a picture of 32768 x 32768 pixels with its maps: expected 1048576.0 GiB of memory, "
                              "found [0-9.]+; ask for a smaller --size or fewer --maps"),
        [] {
            expectMemory({32768, 32768}, std::uint64_t{1} << 20U);
        });
}

}  // namespace
}  // namespace inkedge::raster
