// The notes of an import: merged, ordered, and taken as errors when strict.
#include "expect_error.h"
#include "import/host.h"
#include "import/note_list.h"
#include "note_lines.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <string>

namespace candela {
namespace {

constexpr auto missing = NoteKind::missing, repaired = NoteKind::repaired,
               information = NoteKind::information;

TEST(Notes, OfTheSameTextAreOneWithItsElements) {
    NoteList list;
    list.add(missing, "mesh 3 'wheel'", "fur");
    list.add(missing, "mesh 4", "fur");
    list.add(missing, "mesh 3 'wheel'", "fur");
    const std::vector<ImportNote> notes = list.take();
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].kind, missing);
    EXPECT_EQ(notes[0].text, "fur");
    EXPECT_EQ(notes[0].elements, (Lines{"mesh 3 'wheel'", "mesh 4"}));
    EXPECT_EQ(notes[0].count, 2u);
    EXPECT_EQ(notes[0].line(), "mesh 3 'wheel' and 1 more: fur");
    EXPECT_TRUE(list.take().empty());
}

TEST(Notes, AboutTheFileAreCounted) {
    NoteList list;
    list.add(missing, "", "once");
    for (int i = 0; i < 3; ++i) list.add(repaired, "", "again");
    EXPECT_EQ(noteLines(list.take()), (Lines{"once", "again (3 times)"}));
}

TEST(Notes, AreApartWhereKindTextOrAbsenceOfAnElementDiffers) {
    NoteList list;
    list.add(missing, "mesh 0", "a");
    list.add(repaired, "mesh 0", "a");
    list.add(missing, "mesh 0", "b");
    list.add(missing, "", "a");
    EXPECT_EQ(noteLines(list.take()), (Lines{"mesh 0: a", "mesh 0: b", "a", "mesh 0: a"}));
}

TEST(Notes, BeginWithTheGreatestLoss) {
    NoteList list;
    for (const char* element : {"1", "2", "3"}) list.add(information, element, "i");
    for (const char* element : {"1", "2"}) list.add(repaired, element, "r");
    list.add(missing, "1", "m1");
    for (const char* element : {"1", "2"}) list.add(missing, element, "m2");
    list.add(missing, "1", "m3");
    EXPECT_EQ(noteLines(list.take()),
              (Lines{"1 and 1 more: m2", "1: m1", "1: m3", "1 and 1 more: r", "1 and 2 more: i"}));
}

TEST(Notes, BeyondAThousandTheLeastAreCounted) {
    NoteList list;
    for (int i = 0; i < 1500; ++i) list.add(information, "", std::to_string(i));
    list.add(missing, "", "the worst");
    const std::vector<ImportNote> notes = list.take();
    ASSERT_EQ(notes.size(), 1001u);
    EXPECT_EQ(notes.front().text, "the worst");
    EXPECT_EQ(notes.back().line(), "and 501 more notes");
}

std::vector<ImportNote> notesOf(std::initializer_list<NoteKind> kinds) {
    NoteList list;
    int number = 0;
    for (const NoteKind kind : kinds) list.add(kind, "mesh " + std::to_string(number++), "fur");
    return list.take();
}

TEST(Notes, OfLossesAreRefusedTheLargestFirst) {
    const auto expectRefused = [](std::initializer_list<NoteKind> kinds, const std::string& line) {
        EXPECT_EQ(expectError([&] { refuseLosses(notesOf(kinds), "a.gltf"); }, ErrorKind::badInput, ""),
                  "a.gltf: " + line);
    };
    expectRefused({repaired}, "mesh 0: fur");
    expectRefused({information, repaired, missing, missing}, "mesh 2 and 1 more: fur (and 1 more notes)");
    EXPECT_NO_THROW(refuseLosses(notesOf({information}), "a.gltf"));
    EXPECT_NO_THROW(refuseLosses({}, "a.gltf"));
}

TEST(Notes, OfTheHostAreErrorsOfAStrictImport) {
    const PluginRegistry plugins({std::filesystem::path(CANDELA_TEST_FIXTURES) / "importers"});
    const std::string line =
        "mesh 0 'wheel': normals of length 0 or not finite, replaced by that of a face that uses them";
    EXPECT_EQ(noteLines(importScene(plugins, "add:zero-normal")), Lines{line});
    EXPECT_EQ(expectError(
                  [&] {
                      importScene(plugins, "add:zero-normal", {Strictness::strict, {}});
                  },
                  ErrorKind::badInput, ""),
              "add:zero-normal: " + line);
}

TEST(Notes, OfAnUnknownKindAreRefused) {
    ImportHost host("test", nullptr, {});
    candela_note_kind kind{};
    const std::uint32_t number = 3;
    std::memcpy(&kind, &number, sizeof kind);
    host.interface().add_note(host.interface().self, kind, "mesh 2", "fur");
    expectError([&] { host.rethrowFailure(); }, ErrorKind::badInput, "test: add_note: kind is 3, but 0 to 2");
}

}  // namespace
}  // namespace candela
