// The file of `asperity batch`: entries, each a scene with sweeps of its keys, spread out into the
// single scenes to be run. Pure but for reading; any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/scene/scene.h"

namespace asperity {

/// One scene to run, or why it cannot be.
struct BatchItem {
  std::string name;                                         // of its files
  std::vector<std::pair<std::string, std::string>> varied;  // key and value, of the sweep
  std::string show;                                         // layout of its picture
  Scene scene;
  std::vector<std::filesystem::path> inputs;  // files that it is read from
  Message title;  // of the scene, and what tells it from the others of its sweep
  Message error;                              // one sentence; empty: the scene is good
};

/// The files that an item gives, whatever is shown of it: its picture, table and scene.
std::vector<std::string> filesOf(const BatchItem& item);

struct Batch {
  std::string title;
  std::string size = "960x900";  // of each picture
  std::vector<BatchItem> items;
};

/// What the file may hold, for people.
extern const char* const kBatchFormat;

/// An entry that is wrong becomes an item with an error. Throws InputError where the file as a
/// whole does not read, or where two entries would write one file or one of them a file that
/// belongs to the whole batch.
Batch readBatch(const std::filesystem::path& file);
/// The same from its text; `file` stands for it in errors and names the folder of its scenes.
Batch readBatch(std::string_view json, const std::filesystem::path& file);

}  // namespace asperity
