#include "app/batch/batch_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/batch/batch_page.h"
#include "app/pictures/picture_composer.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/chart/curve_words.h"
#include "core/scene/parameters.h"
#include "core/scene/provenance.h"
#include "core/scene/range.h"
#include "core/scene/scene_file.h"
#include "ui/window/main/scene_library.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargest = std::size_t{1} << 24;  // bytes of the largest batch file
// the deepest nesting: a scene inside an entry inside a list
constexpr int kDeepest = 12;
constexpr std::size_t kMaxItems = 1000;

struct KeySweep {
  std::string key;
  std::vector<std::string> values;
};

/// Returns the values of a range, logarithmic unless it is declared linear.
std::vector<std::string> readSweepRange(const Parameter& row, const Json& spec,
                                        const std::string& where) {
  checkMembers(spec, where, {"from", "to", "points", "scale", "spacing"});
  if (spec.contains("scale") && spec.contains("spacing"))
    refuseMember(where, "scale and spacing mean the same; one of them is enough");
  const std::string member = spec.contains("spacing") ? "spacing" : "scale";
  const std::string log = member == "spacing" ? "logarithmic" : "log";
  const std::string scale = textMember(spec, member.c_str(), log, where);
  if (scale != log && scale != "linear")
    refuseMember(where + "." + member,
                 notOneOf(scale, std::array<std::string_view, 2>{log, "linear"}));
  if (!spec.contains("points")) refuseMember(where + ".points", "is missing; it needs a number");
  const ParameterRange range{&row, rangeEnd(row, spec, where, "from"),
                             rangeEnd(row, spec, where, "to"),
                             integerMember(spec, "points", 2, kMaxItems, where), scale != "linear"};
  if (range.isLogarithmic && !(range.from > 0 && range.to > 0))
    refuseMember(where, "a logarithmic range needs ends above 0");
  std::vector<std::string> texts;
  for (const double value : rangeValues(range)) texts.push_back(fmt::format("{}", value));
  return texts;
}

/// Reads the sweeps of an entry. An error in a sweep names the batch's key, which begins with
/// "sweep".
std::vector<KeySweep> readSweeps(const Json& entry) {
  std::vector<KeySweep> sweeps;
  const auto found = entry.find("sweep");
  if (found == entry.end()) return sweeps;
  if (!found->is_object()) refuseMember("sweep", "needs an object of keys");
  for (const auto& [key, values] : found->items()) {
    const std::string where = "sweep." + shortened(key);
    KeySweep sweep{key, {}};
    try {
      const Parameter& row = knownParameter(key);
      if (values.is_array())
        for (const Json& value : values) sweep.values.push_back(assignedText(value));
      else
        sweep.values = readSweepRange(numberRow(row.key), values, where);
    } catch (const InputError& error) {
      refuseMember(error.key().starts_with(where) ? error.key() : where, error.message());
    }
    if (sweep.values.empty()) refuseMember(where, "has no value");
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

/// Returns the values by which a scene differs from the others of its sweep: "H = 0.3, F = 10 mN".
Message variedInWords(const BatchItem& item) {
  std::vector<Message> parts;
  for (const auto& [key, value] : item.varied) {
    Message words = describeParameter(key, item.scene);
    parts.push_back(words.empty() ? message("{} = {}", key, shortened(value)) : std::move(words));
  }
  return listed(parts);
}

/// Makes the title of an item that has its scene and what is varied in it.
void giveTitle(BatchItem& item) {
  item.title = item.ownTitle;
  if (const Message varied = variedInWords(item); !varied.empty())
    item.title = message("{}; {}", item.title, varied);
  item.scene.title = item.title.english();
}

/// Spreads one entry out into its items.
class Entry {
 public:
  Entry(const Json& json, std::string name, const std::filesystem::path& folder)
      : json_(json), name_(std::move(name)), folder_(folder) {}

  std::vector<BatchItem> items() {
    checkMembers(json_, "entry", {"name", "scene", "set", "sweep", "show"});
    show_ = textMember(json_, "show", "");
    if (!show_.empty()) layoutFrom(show_, "show");
    readSet();
    sweeps_ = readSweeps(json_);
    for (const KeySweep& sweep : sweeps_)
      if (json_.contains("set") && json_["set"].contains(sweep.key))
        refuseMember(sweep.key, "is in set and in sweep; one of them is enough");
    std::size_t count = 1;
    for (const KeySweep& sweep : sweeps_) {
      count *= sweep.values.size();
      if (count > kMaxItems)
        refuseMember("sweep", fmt::format("gives more than {} scenes", kMaxItems));
    }
    std::vector<BatchItem> items;
    for (std::size_t i = 0; i < count; ++i) items.push_back(item(i, count));
    return items;
  }

 private:
  void readSet() {
    const auto set = json_.find("set");
    if (set == json_.end()) return;
    if (!set->is_object()) refuseMember("set", "needs an object of keys");
    for (const auto& [key, value] : set->items()) set_.push_back(key + "=" + assignedText(value));
  }

  /// Returns one item of the grid of all sweeps; the last key changes fastest.
  BatchItem item(std::size_t number, std::size_t count) {
    BatchItem item;
    item.name = count == 1 ? name_ : fmt::format("{}_{:0{}}", name_, number + 1, digits(count));
    std::vector<std::string> assignments = set_;
    for (std::size_t left = count; const KeySweep& sweep : sweeps_) {
      left /= sweep.values.size();
      const std::string& value = sweep.values[number / left % sweep.values.size()];
      item.varied.emplace_back(sweep.key, value);
      assignments.push_back(sweep.key + "=" + value);
    }
    if (json_.contains("scene") && json_["scene"].is_string())
      item.inputs.push_back(folder_ / json_["scene"].get<std::string>());
    try {
      item.scene = sceneWith(assignments);
      for (const std::filesystem::path& file : filesReadBy(item.scene)) item.inputs.push_back(file);
      item.ownTitle = item.scene.title.empty() ? name_ : item.scene.title;
      giveTitle(item);
      const bool isSteady = item.scene.sliding.kind == SlidingKind::Steady;
      item.show = !show_.empty() ? show_ : isSteady ? "both" : "transient";
    } catch (const InputError& error) {
      item.error = errorMessage(error);
    }
    return item;
  }

  static std::size_t digits(std::size_t count) {
    return std::max<std::size_t>(2, std::to_string(count).size());
  }

  Scene sceneWith(const std::vector<std::string>& assignments) const {
    const auto scene = json_.find("scene");
    if (scene == json_.end()) return readScene("{}", "scene", folder_, assignments);
    if (scene->is_string()) return readNamedScene(scene->get<std::string>(), folder_, assignments);
    return readScene(scene->dump(), "scene", folder_, assignments);
  }

  const Json& json_;
  std::string name_;
  std::filesystem::path folder_;
  std::string show_;
  std::vector<std::string> set_;
  std::vector<KeySweep> sweeps_;
};

/// Returns what a file of the whole batch contains; it is empty where the batch writes no such
/// file.
std::string_view contentOfCommonFile(const std::string& file) {
  if (file == "index.html") return "the page of all scenes";
  if (file == "results.csv") return "the table of all scenes";
  return isSheetName(file) ? "the pictures of all scenes" : std::string_view();
}

/// Collects the names of all files that the items of one entry will write, and checks that no
/// earlier entry writes them.
class OutputNames {
 public:
  void add(const BatchItem& item, std::size_t entry) {
    for (const std::string& file : outputFiles(item)) {
      const std::string key = fmt::format("entries[{}].name", entry - 1);
      if (const std::string_view content = contentOfCommonFile(file); !content.empty())
        refuseMember(key,
                     fmt::format("'{}' would write {}, which holds {}", item.name, file, content));
      const auto [known, isNew] = writtenBy_.emplace(file, entry);
      if (!isNew)
        refuseMember(key, fmt::format("'{}' would write {}, as entries[{}] does", item.name, file,
                                      known->second - 1));
    }
  }

 private:
  std::map<std::string, std::size_t> writtenBy_;  // file -> number of the entry
};

void addEntry(Batch& batch, const Json& json, std::size_t number,
              const std::filesystem::path& folder, std::set<std::string>& names) {
  std::string name = fmt::format("entry_{}", number);
  try {
    if (json.is_object()) name = makeFileName(textMember(json, "name", name));
    const std::string where = fmt::format("entries[{}].name", number - 1);
    if (name.empty()) refuseMember(where, "is empty");
    if (!names.insert(name).second) refuseMember(where, "occurs twice");
    std::vector<BatchItem> items = Entry(json, name, folder).items();
    if (batch.items.size() + items.size() > kMaxItems)
      refuseMember("", fmt::format("a batch may have {} scenes", kMaxItems));
    std::move(items.begin(), items.end(), std::back_inserter(batch.items));
  } catch (const InputError& error) {
    if (error.key().starts_with("sweep"))
      refuseMember(fmt::format("entries[{}].{}", number - 1, error.key()), error.message());
    BatchItem item;
    item.name = name;
    item.error = errorMessage(error);
    batch.items.push_back(std::move(item));
  }
}

}  // namespace

const char* const kBatchFormat =
    R"(FILE.json:
  {"schema": "asperity-batch/1", "title": "Forces and exponents", "size": "960x900",
   "entries": [
     {"name": "paper", "scene": "figure_2.json", "show": "both",
      "set": {"ensemble.realizations": 20},
      "sweep": {"load.normal_force": {"from": 1e-3, "to": 10, "points": 5},
                "surface.hurst": [0.3, 0.7, 1]}}]}
An entry's scene is a file (relative to the batch's), the name of a shipped scene, or a scene
itself; set and sweep take any scene key, with units as texts: "1 mN". A sweep is a list, or a range,
logarithmic unless "scale": "linear"; several keys make a grid. show: contact, curve, both, or
transient. Curves show the measured friction that their scenes name (comparison.data).
DIR gets index.html, results.csv, contact_sheet.png (of more than 100 scenes only with
--contact-sheet), and for each scene NAME.png, NAME.json (the scene) and, of curve, both and
transient, NAME.csv: the curve, or the motion as asperity motion writes it, in at most 2000 rows. In
results.csv mu, indentation and contact_fraction are means over the scene's lines at its velocity,
empty for a motion; mu_total includes local friction; line_mu and its like are of the line shown.
An entry with a mistake is named and left out; the others are made, and the exit status is 1.)";

std::vector<std::string> outputFiles(const BatchItem& item) {
  return {item.name + ".png", item.name + ".csv", item.name + ".json"};
}

Batch readBatch(const std::filesystem::path& file) {
  return readBatch(readWholeFile(file, kLargest), file);
}

Batch readBatch(std::string_view json, const std::filesystem::path& file) {
  try {
    const Json root = parseJson(json, kDeepest);
    checkMembers(root, "", {"schema", "title", "size", "entries"});
    if (textMember(root, "schema", "") != "asperity-batch/1")
      refuseMember("schema", "is not asperity-batch/1");
    Batch batch;
    batch.title = textMember(root, "title", "Batch");
    batch.size = textMember(root, "size", batch.size);
    const auto entries = root.find("entries");
    if (entries == root.end() || !entries->is_array() || entries->empty())
      refuseMember("entries", "needs a list of entries");
    std::set<std::string> names;
    OutputNames outputs;
    for (std::size_t i = 0, first = 0; i < entries->size(); ++i) {
      addEntry(batch, (*entries)[i], i + 1, file.parent_path(), names);
      for (; first < batch.items.size(); ++first)
        if (batch.items[first].error.empty()) outputs.add(batch.items[first], i + 1);
    }
    return batch;
  } catch (const InputError& error) {
    throw error.withFile(file.string());
  }
}

nlohmann::ordered_json itemJson(const BatchItem& item) {
  Json json = {{"name", item.name}};
  if (item.error.empty()) {
    json["show"] = item.show;
    json["title"] = item.ownTitle;
  }
  Json& varied = json["varied"] = Json::object();
  for (const auto& [key, value] : item.varied) varied[key] = value;
  if (!item.error.empty()) json["error"] = item.error.english();
  return json;
}

namespace {

BatchItem itemFrom(const Json& json, const Scene& scene) {
  checkMembers(json, "entry", {"name", "show", "title", "varied", "error", "inputs", "scene"});
  BatchItem item;
  item.name = textMember(json, "name");
  // A name in a foreign file must not lead out of the folder.
  if (item.name.empty() || item.name.find_first_of("./") != std::string::npos)
    refuseMember("name", message("'{}' is not a name of a scene", shortened(item.name)));
  item.show = textMember(json, "show");
  item.ownTitle = textMember(json, "title");
  item.error = Message::name(textMember(json, "error"));
  if (const auto varied = json.find("varied"); varied != json.end() && varied->is_object())
    for (const auto& [key, value] : varied->items()) {
      knownParameter(key);
      item.varied.emplace_back(key, assignedText(value));
    }
  item.scene = scene;
  if (!item.error.empty()) return item;
  layoutFrom(item.show, "show");
  giveTitle(item);
  return item;
}

}  // namespace

Batch restoreBatch(const FoundScene& found) {
  Batch batch;
  const Json& options = found.options;
  if (found.parts.empty()) {
    if (!options.contains("entry")) refuseMember("entry", "is missing");
    batch.items.push_back(itemFrom(options["entry"], found.scene));
    return batch;
  }
  batch.title = textMember(options, "title", "Batch");
  for (const FoundScene& part : found.parts)
    batch.items.push_back(itemFrom(part.origin, part.scene));
  return batch;
}

}  // namespace asperity
