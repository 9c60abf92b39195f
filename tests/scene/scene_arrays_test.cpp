#include <inkedge/scene_arrays.h>

#include <array>
#include <limits>
#include <vector>

#include <gmock/gmock.h>

#include <inkedge/error.h>
#include <inkedge/scene_names.h>

#include "base/expect_error.h"

namespace inkedge::scene {
namespace {

using testing::StartsWith;

const std::array<float, 9> corners{0, 0, 0, 2, 0, 0, 0, 2, 0};

InstancedArrays triangle(const char* name) {
    InstancedArrays arrays;
    arrays.mesh.name = name;
    arrays.mesh.positions = {corners.data(), NumberType::Float32, 3, 3};
    return arrays;
}

// Rows of two matrices: as it is, and moved by (10, 20, 30).
const std::vector<double> twice{1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1,
                                1, 0, 0, 10, 0, 1, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1};

TEST(MakeScene, standsWhereItsArraysSay) {
    InstancedArrays arrays = triangle("plate");
    arrays.transforms = {twice.data(), NumberType::Float64, 2, 16};
    arrays.names = {"left", "right"};
    const Scene scene = makeScene({{arrays, triangle("lid")}}, {.unit = LengthUnit::Inch});
    EXPECT_EQ(scene.triangleCount(), 3U);
    EXPECT_EQ(scene.box().max, glm::dvec3(12, 22, 30));
    EXPECT_EQ(scene.source().unit, LengthUnit::Inch);
    const SceneNames names = namesOf(scene);
    ASSERT_EQ(names.instances.size(), 3U);
    EXPECT_EQ(names.instances[0].node, "left");
    EXPECT_EQ(names.instances[1].node, "right");
    EXPECT_EQ(names.instances[1].mesh, "plate");
    EXPECT_EQ(names.instances[2].node, "lid");
}

TEST(MakeScene, saysWhichOfSeveralMeshesIsWrong) {
    InstancedArrays wrong = triangle("lid");
    wrong.mesh.positions.columns = 2;
    expectError(Error::Kind::Usage, testing::StrEq("positions: expected 3 numbers a row, found 2"),
                [&] { (void)makeScene({{wrong}}); });
    expectError(Error::Kind::Usage, testing::StrEq("mesh 1 'lid': positions: expected 3 numbers a row, found 2"), [&] {
        (void)makeScene({{triangle("plate"), wrong}});
    });
}

TEST(MakeScene, refusesTransformsAndNamesThatDoNotFit) {
    InstancedArrays arrays = triangle("plate");
    arrays.transforms = {twice.data(), NumberType::Float64, 2, 16};
    arrays.names = {"left"};
    expectError(Error::Kind::Usage, testing::StrEq("names: expected 2, one an instance, found 1"),
                [&] { (void)makeScene({{arrays}}); });
    arrays.names.clear();
    for (const double wrong : {1.0, std::numeric_limits<double>::quiet_NaN()}) {
        std::vector<double> numbers = twice;
        numbers[16 + 12] = wrong;
        arrays.transforms.data = numbers.data();
        expectError(Error::Kind::Usage, StartsWith("transforms: expected finite matrices whose last row is 0, 0, 0, 1"),
                    [&] { (void)makeScene({{arrays}}); });
    }
    arrays.transforms = {twice.data(), NumberType::Float64, 4, 8};
    expectError(Error::Kind::Usage, testing::StrEq("transforms: expected 16 numbers a row, found 8"),
                [&] { (void)makeScene({{arrays}}); });
}

}  // namespace
}  // namespace inkedge::scene
