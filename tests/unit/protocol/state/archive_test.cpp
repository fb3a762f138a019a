#include "protocol/state/archive.hpp"

#include <gmock/gmock.h>

#include <numeric>
#include <optional>
#include <utility>

#include "tests/support/refusals.hpp"

namespace adit::state::archive_test {
namespace {

struct Spring {
  double force = 0;
  std::uint32_t particle = 0;
  void exchange(Archive& archive) { archive("spring", force); }
};

// Something of each kind that a state holds.
struct Model {
  std::vector<double> places;       // as many as the model has
  std::vector<std::uint32_t> list;  // any number
  std::vector<bool> broken;
  std::optional<Spring> spring;
  std::string text;
  bool flag = false;

  void exchange(Archive& archive) {
    archive("places", std::span(places));
    archive("list", list);
    archive("broken", broken);
    archive("spring", spring, [] { return Spring{}; });
    archive("text", text);
    archive("flag", flag);
  }
};

Model written() {
  return {{0.1, -0.0, 5e-324}, {7, 8, 9, 10}, {true, false, true}, Spring{3.5, 2}, "crown", true};
}

Parts bytes_of(Model model) {
  Archive archive;
  model.exchange(archive);
  return archive.take();
}

void read(Parts parts, Model& model) {
  Archive archive(std::move(parts));
  model.exchange(archive);
  archive.require_end();
}

// What was written is read to the bit, into an object whose lists had other lengths.
TEST(Archive, ReadsWhatItWrote) {
  Model model{{1, 2, 3}, {}, {false, false, false}, {}, "", false};
  read(bytes_of(written()), model);
  EXPECT_THAT(model.places, testing::ElementsAre(0.1, -0.0, 5e-324));
  EXPECT_TRUE(std::signbit(model.places[1]));
  EXPECT_THAT(model.list, testing::ElementsAre(7, 8, 9, 10));
  EXPECT_THAT(model.broken, testing::ElementsAre(true, false, true));
  ASSERT_TRUE(model.spring);
  EXPECT_EQ(model.spring->force, 3.5);
  EXPECT_EQ(model.text, "crown");
  EXPECT_TRUE(model.flag);
}

// What was not there when the state was written is not there when it was read.
TEST(Archive, TakesAwayWhatWasNotThere) {
  Model without = written();
  without.spring.reset();
  Model model = written();
  read(bytes_of(without), model);
  EXPECT_FALSE(model.spring);
}

// Values that lie on both sides of the end of a part are whole.
TEST(Archive, CrossesParts) {
  std::vector<std::uint32_t> many(5'000'000);
  std::iota(many.begin(), many.end(), 0u);
  Model model = written();
  model.list = many;
  const Parts parts = bytes_of(model);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].size(), kPartBytes);
  EXPECT_EQ(size_of(parts), 2 * kPartBytes + parts[2].size());
  model.list.clear();
  read(parts, model);
  EXPECT_EQ(model.list, many);
}

// A state that ends anywhere before its end is refused, and so is one that goes on after it.
TEST(Archive, RefusesAStateThatIsNotWhole) {
  const std::string whole = bytes_of(written()).front();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    Model model = written();
    EXPECT_THROW(read({whole.substr(0, length)}, model), protocol::UserError) << length;
  }
  Model model = written();
  test::expect_refusal([&] { read({whole + "x"}, model); }, "", "more than the model has");
}

// A number of values is believed only where so many follow: no memory is taken for others.
TEST(Archive, RefusesLengthsThatCannotBe) {
  std::string bytes = bytes_of(written()).front();
  const std::size_t number = bytes.find("list") + 4 + 8;  // behind the name and the size of a value
  bytes.replace(number, 8, std::string(7, '\xff') + '\x0f');
  Model model = written();
  test::expect_refusal([&] { read({bytes}, model); }, "", "it ends within `list`");
}

// A state of another model is refused by the name of what does not fit.
TEST(Archive, NamesWhatDoesNotFit) {
  Model smaller = written();
  smaller.places.pop_back();
  test::expect_refusal([&] { read(bytes_of(written()), smaller); }, "", "`places` has 3 values, the model 2");
  Archive other;
  double value = 1;
  other("faces!", value);
  Model model = written();
  test::expect_refusal([&] { read(other.take(), model); }, "",
                       "it holds `faces!` where `places` was expected");
}

// CRC-32 as everybody computes it: the check value of the catalogue of its parameters.
TEST(Archive, ChecksumIsThatOfIso3309) {
  EXPECT_EQ(checksum("123456789"), 0xcbf43926u);
}

// What the scene determines of an object is not in a state, so that no state can change it.
TEST(Archive, LeavesTheOtherMembersAlone) {
  std::vector<Spring> springs{{1.5, 3}, {2.5, 4}}, others{{0, 7}, {0, 8}};
  Archive writes;
  writes.members("springs", std::span(springs), &Spring::force);
  Archive reads(writes.take());
  reads.members("springs", std::span(others), &Spring::force);
  reads.require_end();
  EXPECT_EQ(others[0].force, 1.5);
  EXPECT_EQ(others[1].force, 2.5);
  EXPECT_EQ(others[0].particle, 7u);
}

// Lists that belong together are all there, with the number that the model has, or all absent.
TEST(Archive, TakesAllListsOrNone) {
  const auto pass = [](std::vector<double> a, std::vector<double> b, std::size_t count) {
    Archive writes;
    writes.all_or_none("lists", {&a, &b}, a.size());
    std::vector<double> c{9}, d;
    Archive reads(writes.take());
    reads.all_or_none("lists", {&c, &d}, count);
    return std::pair(c, d);
  };
  EXPECT_EQ(pass({1, 2}, {3, 4}, 2), std::pair(std::vector{1.0, 2.0}, std::vector{3.0, 4.0}));
  EXPECT_EQ(pass({}, {}, 2), std::pair(std::vector<double>(), std::vector<double>()));
  test::expect_refusal([&] { pass({1, 2}, {3, 4}, 3); }, "", "`lists` has 2 values, the model 3");
}

// A byte that is neither 0 nor 1 is no fault of the reader.
TEST(Archive, ReadsAnyFlag) {
  std::string bytes = bytes_of(written()).front();
  bytes.back() = '\x55';
  Model model = written();
  model.flag = false;
  read({bytes}, model);
  EXPECT_TRUE(model.flag);
}

TEST(Archive, RefusesWhatIsNotOfTheModel) {
  require_of_model(true, "pairs");
  test::expect_refusal([] { require_of_model(false, "pairs"); }, "", "`pairs` is not of this model");
}

TEST(Archive, RefusesNumbersOfWhatIsNotThere) {
  const std::vector<std::uint32_t> numbers{0, 3};
  require_below(numbers, 4, "pairs");
  test::expect_refusal([&] { require_below(numbers, 3, "pairs"); }, "", "`pairs` names what");
}

}  // namespace
}  // namespace adit::state::archive_test
