// Every reader on its corpus and on 1500 inputs made from it, always the same ones: in the preset
// `asan` under the sanitizers. `./dev fuzz` looks for new inputs with libFuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/readers.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr int kInputs = 1500;
constexpr std::size_t kLongest = 131072;

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> corpusOf(std::string_view reader) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(ASPERITY_TESTS_DIR "/fuzz/corpus") / reader))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const fs::path& file : files) inputs.push_back(contents(file));
  return inputs;
}

/// Returns the quoted words of scene.dict.
std::vector<std::string> dictionary() {
  std::ifstream stream(ASPERITY_TESTS_DIR "/fuzz/scene.dict");
  std::vector<std::string> words;
  for (std::string line; std::getline(stream, line);)
    if (line.size() > 2 && line.front() == '"') words.push_back(line.substr(1, line.size() - 2));
  return words;
}

/// Changes inputs at random. The numbers depend on the seed only, on every machine.
class Mutator {
 public:
  explicit Mutator(std::vector<std::string> corpus)
      : corpus_(std::move(corpus)), words_(dictionary()) {}

  std::string next() {
    std::string input = corpus_[below(corpus_.size())];
    for (std::size_t changes = 1 + below(6); changes > 0; --changes) change(input);
    input.resize(std::min(input.size(), kLongest));
    return input;
  }

 private:
  std::size_t below(std::size_t limit) { return limit ? generator_() % limit : 0; }

  void change(std::string& input) {
    const std::size_t at = below(input.size() + 1);
    const std::size_t length = std::min(1 + below(1 + input.size() / 4), input.size() - at);
    switch (below(8)) {
      case 0:  // another bit
        if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
        break;
      case 1:  // any byte
        if (at < input.size()) input[at] = static_cast<char>(below(256));
        break;
      case 2:
        input.erase(at, length);
        break;
      case 3:
        input.insert(at, input.substr(at, length));
        break;
      case 4:
        input.resize(at);
        break;
      case 5:
        input.insert(at, words_[below(words_.size())]);
        break;
      case 6: {  // a digit becomes another character of numbers
        const std::size_t digit = input.find_first_of("0123456789", at);
        if (digit != std::string::npos) input[digit] = "0123456789.-+eE"[below(15)];
        break;
      }
      default: {  // a piece of another input
        const std::string& other = corpus_[below(corpus_.size())];
        const std::size_t begin = below(other.size() + 1);
        input.replace(at, length, other, begin, below(other.size() - begin + 1));
      }
    }
  }

  std::vector<std::string> corpus_, words_;
  std::mt19937_64 generator_{1};
};

class ReaderOfAnything : public testing::TestWithParam<ReaderUnderTest> {};

TEST_P(ReaderOfAnything, ReadsOrRefuses) {
  const std::vector<std::string> corpus = corpusOf(GetParam().name);
  ASSERT_FALSE(corpus.empty());
  for (const std::string& input : corpus) EXPECT_NO_THROW(GetParam().read(input));
  Mutator mutator(corpus);
  for (int i = 0; i < kInputs; ++i) {
    const std::string input = mutator.next();
    EXPECT_NO_THROW(GetParam().read(input)) << "input " << i << ": " << input.substr(0, 2000);
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, ReaderOfAnything,
                         testing::ValuesIn(readersUnderTest().begin(), readersUnderTest().end()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(ReadersUnderTest, HaveAFolderOfInputsEach) {
  std::vector<std::string> folders, names;
  for (const auto& entry : fs::directory_iterator(ASPERITY_TESTS_DIR "/fuzz/corpus"))
    folders.push_back(entry.path().filename());
  for (const ReaderUnderTest& reader : readersUnderTest()) names.emplace_back(reader.name);
  std::sort(folders.begin(), folders.end());
  EXPECT_EQ(folders, names);
}

}  // namespace
}  // namespace asperity
