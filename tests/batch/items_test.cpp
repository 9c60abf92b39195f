// Lines that are items, and lines that are none.
#include "batch/items.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"

namespace inkedge::batch {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using Kind = Error::Kind;

TEST(ItemFrom, takesAPathOrJson) {
    const Item path = itemFrom("/data/../models/./a b.glb");
    EXPECT_EQ(path.model, "/data/../models/./a b.glb");
    EXPECT_EQ(path.id, "models/a b.glb");
    EXPECT_EQ(itemFrom("../../up/a.stl").id, "up/a.stl");
    const Item json = itemFrom(
        R"({"model": "a.stl", "id": "set/7", "views": "random:2:9", "settings": {"size": "64x64", "fov": 20}})");
    EXPECT_EQ(json.model, "a.stl");
    EXPECT_EQ(json.id, "set/7");
    EXPECT_EQ(json.views, "random:2:9");
    EXPECT_EQ(json.settings["fov"], 20);
    EXPECT_EQ(itemFrom(R"({"model": "x/a.stl"})").id, "x/a.stl");
}

TEST(ItemFrom, refusesWhatIsNone) {
    const auto refused = [](const std::string& line, const std::string& message) {
        expectError(Kind::Input, AllOf(HasSubstr("expected "), HasSubstr(", found "), HasSubstr(message)),
                    [&] { static_cast<void>(itemFrom(line)); });
    };
    refused(R"({"model": "a.stl")", "expected JSON, found something else at byte");
    refused(R"({"id": "a"})", "model: expected a text, found none");
    refused(R"({"model": 3})", "model: expected a text, found '3'");
    refused(R"({"model": ""})", "model: expected a path, found an empty text");
    refused(R"({"model": "a.stl", "id": ""})", "id: expected a name, found an empty text");
    refused(R"({"model": "a.stl", "id": 7})", "id: expected a text, found '7'");
    refused(R"({"model": "a.stl", "settings": "x"})", "settings: expected an object, found 'x'");
    refused(R"({"model": "a.stl", "setting": {}})", "expected model, id, views and settings, found 'setting'");
    refused(R"({"model": "a.stl", "model": "b.stl"})", "expected each key once, found 'model' again");
    refused(R"({"model": "a.stl", "settings": {"a": [[[[[[[[[1]]]]]]]]]}})", "lists and objects in each other");
}

TEST(ItemFrom, refusesIdsThatLeadOutOrAreNoNames) {
    for (const std::string id : {"../a", "/a", "a/../b", ".", "a/./b", "a//b", "a/", ".hidden", "a\\\\b", "a\\nb",
                                 "results.jsonl", "results.3-of-8.jsonl", "batch.json/a", "gallery.html"})
        expectError(Kind::Input, AllOf(HasSubstr("id: expected names with / between them"), HasSubstr(", found ")),
                    [&] { static_cast<void>(itemFrom(R"({"model": "a.stl", "id": ")" + id + "\"}")); });
    expectError(Kind::Input, HasSubstr("found one of over 255 bytes in "),
                [] { static_cast<void>(itemFrom(std::string(300, 'x') + ".stl")); });
    expectError(Kind::Input, HasSubstr("found bytes that are no UTF-8 in "),
                [] { static_cast<void>(itemFrom("\xff.stl")); });
}

TEST(ItemFrom, takesWhatAnItemBecame) {
    const std::string line = R"({"model":"m \u00e4.stl","id":"a/b","views":"front","settings":{"size":"9x9"}})";
    const Item item = itemFrom(lineOf(itemFrom(line)));
    EXPECT_EQ(item.model, "m ä.stl");
    EXPECT_EQ(item.id, "a/b");
    EXPECT_EQ(item.views, "front");
    EXPECT_EQ(item.settings, io::Json({{"size", "9x9"}}));
    EXPECT_EQ(itemFrom(lineOf(itemFrom("x.stl"))).settings, nullptr);
}

class ItemsOf : public testing::Test {
protected:
    std::vector<std::string> ids(const std::filesystem::path& input) const {
        Items items{input, folder_ / "out"};
        std::vector<std::string> ids;
        while (true) {
            try {
                const auto item = items.next();
                if (!item) return ids;
                EXPECT_EQ(item->number, ids.size() - errors(ids));
                ids.push_back(item->id);
            } catch (const Error& error) {
                ids.push_back(std::string{"error: "} + error.what());
            }
        }
    }
    static std::size_t errors(const std::vector<std::string>& ids) {
        return static_cast<std::size_t>(
            std::ranges::count_if(ids, [](const std::string& id) { return id.starts_with("error: "); }));
    }

    TemporaryFolder folder_;
};

TEST_F(ItemsOf, aFileAreItsLines) {
    const std::filesystem::path list = folder_ / "list";
    put(list,
        "\xef\xbb\xbf"
        "a.stl\r\n\n  \n{\"model\": \"b.stl\"}\n{]\n" +
            std::string(70'000, 'x') + "\nlast.stl");
    EXPECT_THAT(
        ids(list),
        ElementsAre("a.stl", "b.stl", "error: " + list.string() + ":5: expected JSON, found something else at byte 2",
                    "error: " + list.string() + ":6: expected at most 65536 bytes, found more", "last.stl"));
    put(folder_ / "empty", "");
    EXPECT_THAT(ids(folder_ / "empty"), testing::IsEmpty());
}

TEST_F(ItemsOf, aFolderAreTheModelsInIt) {
    for (const char* name : {"models/b", "models/a/c", "models/.git", "models/out"})
        std::filesystem::create_directories(folder_ / name);
    for (const char* name :
         {"models/z.STL", "models/b/y.glb", "models/b/y.bin", "models/a/c/x.step", "models/.git/h.stl",
          "models/.hidden.stl", "models/a.obj", "models/out/o.stl", "models/a-1.ply"})
        put(folder_ / name, "x");
    std::filesystem::create_directory_symlink(folder_ / "models", folder_ / "models/b/loop");
    std::filesystem::create_symlink(folder_ / "models/a.obj", folder_ / "models/link.obj");
    std::filesystem::create_directory_symlink(folder_ / "models", folder_ / "behind");
    const auto found = [&](const std::string& input) {
        Items items{folder_ / input, folder_ / "models/out"};
        std::vector<std::string> ids;
        while (const auto item = items.next()) ids.push_back(item->id);
        return ids;
    };
    const auto expected = ElementsAre("a/c/x.step", "a-1.ply", "a.obj", "b/y.glb", "link.obj", "z.STL");
    EXPECT_THAT(found("models"), expected);
    EXPECT_THAT(found("models/"), expected);
    EXPECT_THAT(found("behind"), expected);
}

TEST_F(ItemsOf, portionsAreAllOfThemAndEachOnce) {
    std::string text = "{]\n";
    for (int i = 0; i < 50; ++i) text += std::to_string(i) + ".stl\n";
    put(folder_ / "list", text);
    std::vector<std::string> all;
    for (std::uint64_t index = 0; index < 3; ++index) {
        Items items{folder_ / "list", folder_ / "out", {index, 3}};
        for (std::uint64_t number = 0;;) {
            try {
                const auto item = items.next();
                if (!item) break;
                EXPECT_EQ(item->number, number++) << "counted in the portion, for shards";
                all.push_back(item->id);
            } catch (const Error&) {
                all.emplace_back("error");
            }
        }
    }
    std::vector<std::string> expected = ids(folder_ / "list");
    expected.front() = "error";
    EXPECT_THAT(all, testing::UnorderedElementsAreArray(expected));
}

TEST_F(ItemsOf, somethingElseAreRefused) {
    expectError(Kind::Input, HasSubstr("expected a folder of models or a file with an item a line, found none"), [&] {
        const Items items{folder_ / "missing", folder_ / "out"};
    });
    put(folder_ / "a.glb", "glTF");
    expectError(Kind::Usage, HasSubstr("found a model; inkedge render draws it"), [&] {
        const Items items{folder_ / "a.glb", folder_ / "out"};
    });
}

}  // namespace
}  // namespace inkedge::batch
