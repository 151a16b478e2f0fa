#include "core/scene/list_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/material/temperature_shift.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<ArmMember, 2> kArmMembers{
    {{"modulus", &Arm::modulus, 0, 1e15, "Pa"},
     {"relaxation_time", &Arm::relaxationTime, 0, 1e12, "s"}}};

constexpr std::array<ListMember<ShiftPoint>, 2> kShiftMembers{
    {{"temperature", &ShiftPoint::temperature, 1, 2000, "K"},
     {"log10_shift", &ShiftPoint::log10Shift, -kMaxDecades, kMaxDecades, ""}}};

template <class Row>
Message allowed(const ListMember<Row>& member) {
  return rangeText(member.least, member.most, member.unit);
}

Json parsedList(std::string_view json, const std::string& key, const Message& allowedList) {
  Json list = jsonOrDiscarded(json);
  if (list.is_discarded())
    throw InputError("", key, message("is not a list in JSON; allowed is {}", allowedList));
  if (!list.is_array()) throw InputError("", key, message("needs {}", allowedList));
  return list;
}

/// The sentences name the members, so each list has its own.
struct RowTexts {
  Message wrongType, unknownKey;
};

template <class Row, std::size_t Count>
Row rowFrom(const Json& json, const std::string& key,
            const std::array<ListMember<Row>, Count>& members, const RowTexts& texts) {
  if (!json.is_object()) throw InputError("", key, texts.wrongType);
  for (const auto& [name, value] : json.items())
    if (std::none_of(members.begin(), members.end(),
                     [&](const ListMember<Row>& member) { return name == member.name; }))
      throw InputError("", key + "." + shortened(name), texts.unknownKey);
  Row row;
  for (const ListMember<Row>& member : members) {
    const std::string path = key + "." + member.name;
    if (!json.contains(member.name)) throw InputError("", path, "is missing");
    const Json& value = json[member.name];
    if (!value.is_number())
      throw InputError("", path, message("is not a number; allowed is {}", allowed(member)));
    const auto number = value.get<double>();
    if (!(number >= member.least && number <= member.most))
      throw InputError("", path, message("{} is outside {}", plain(number), allowed(member)));
    row.*member.value = number;
  }
  return row;
}

template <class Row, std::size_t Count>
std::string listText(const std::vector<Row>& rows,
                     const std::array<ListMember<Row>, Count>& members) {
  Json list = Json::array();
  for (const Row& row : rows) {
    Json one;
    for (const ListMember<Row>& member : members) one[member.name] = row.*member.value;
    list.push_back(std::move(one));
  }
  return jsonLine(list);
}

}  // namespace

std::span<const ListMember<ShiftPoint>> shiftMembers() {
  return kShiftMembers;
}

std::span<const ArmMember> armMembers() {
  return kArmMembers;
}

std::vector<Arm> parseArms(std::string_view json, const std::string& key) {
  const Json list = parsedList(json, key, allowedArms());
  if (list.size() > kMaxArms)
    throw InputError("", key, message("has {} arms; allowed is {}", list.size(), allowedArms()));
  const RowTexts texts{"needs an object of modulus and relaxation_time",
                       "unknown key; an arm has modulus and relaxation_time"};
  std::vector<Arm> arms;
  for (std::size_t i = 0; i < list.size(); ++i)
    arms.push_back(rowFrom(list[i], fmt::format("{}[{}]", key, i), kArmMembers, texts));
  return arms;
}

std::vector<ShiftPoint> parseShiftTable(std::string_view json, const std::string& key) {
  const Json list = parsedList(json, key, allowedShiftTable());
  if (list.empty() || list.size() > kMaxShiftPoints)
    throw InputError("", key,
                     message("has {} rows; allowed is {}", list.size(), allowedShiftTable()));
  const RowTexts texts{"needs an object of temperature and log10_shift",
                       "unknown key; a row has temperature and log10_shift"};
  std::vector<ShiftPoint> table;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string path = fmt::format("{}[{}]", key, i);
    table.push_back(rowFrom(list[i], path, kShiftMembers, texts));
    if (i > 0 && !(table[i].temperature > table[i - 1].temperature))
      throw InputError("", path + ".temperature",
                       message("{} K is not above the {} K of the row before; the rows are needed "
                               "in the order of rising temperature",
                               table[i].temperature, table[i - 1].temperature));
  }
  return table;
}

std::string listText(const std::vector<Arm>& arms) {
  return listText(arms, kArmMembers);
}

std::string listText(const std::vector<ShiftPoint>& table) {
  return listText(table, kShiftMembers);
}

Message allowedArms() {
  return message("a list of 0 to {} {{modulus, relaxation_time}}, {} and {}", kMaxArms,
                 allowed(kArmMembers[0]), allowed(kArmMembers[1]));
}

Message allowedShiftTable() {
  return message("a list of 1 to {} {{temperature, log10_shift}}, {} and {}", kMaxShiftPoints,
                 allowed(kShiftMembers[0]), allowed(kShiftMembers[1]));
}

std::vector<DataFile> parseDataFiles(std::string_view json, const std::string& key) {
  const Json list = parsedList(json, key, allowedDataFiles());
  if (list.size() > kMaxDataFiles)
    throw InputError("", key,
                     message("has {} tables; allowed is {}", list.size(), allowedDataFiles()));
  std::vector<DataFile> files;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string path = fmt::format("{}[{}]", key, i);
    if (!list[i].is_object()) throw InputError("", path, "needs an object of file and label");
    DataFile data;
    for (const auto& [name, value] : list[i].items()) {
      if (name != "file" && name != "label")
        throw InputError("", path + "." + shortened(name),
                         "unknown key; a table has file and label");
      if (!value.is_string()) throw InputError("", path + "." + name, "is not a text");
      (name == "file" ? data.file : data.label) = value.get<std::string>();
    }
    if (data.file.empty()) throw InputError("", path + ".file", "is missing");
    files.push_back(std::move(data));
  }
  return files;
}

std::string listText(const std::vector<DataFile>& files) {
  Json list = Json::array();
  for (const DataFile& data : files) {
    Json one = {{"file", data.file}};
    if (!data.label.empty()) one["label"] = data.label;
    list.push_back(std::move(one));
  }
  return jsonLine(list);
}

std::span<const std::string_view> theoryWords() {
  static constexpr std::array<std::string_view, 4> kWords{"eq_11", "gaussian_foundation",
                                                          "complete_contact", "persson_half_space"};
  return kWords;
}

std::vector<Theory> parseTheories(std::string_view json, const std::string& key) {
  const Json list = parsedList(json, key, allowedTheories());
  std::vector<Theory> theories;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string path = fmt::format("{}[{}]", key, i);
    if (!list[i].is_string()) throw InputError("", path, message("needs {}", allowedTheories()));
    const auto word = list[i].get<std::string>();
    const auto known = std::ranges::find(theoryWords(), word);
    if (known == theoryWords().end()) throw InputError("", path, notOneOf(word, theoryWords()));
    const auto theory = static_cast<Theory>(known - theoryWords().begin());
    if (std::ranges::find(theories, theory) != theories.end())
      throw InputError("", path, message("{} is named twice", word));
    theories.push_back(theory);
  }
  return theories;
}

std::string listText(const std::vector<Theory>& theories) {
  Json list = Json::array();
  for (const Theory theory : theories)
    list.push_back(theoryWords()[static_cast<std::size_t>(theory)]);
  return jsonLine(list);
}

Message allowedDataFiles() {
  return message("a list of 0 to {} {{file, label}}", kMaxDataFiles);
}

Message allowedTheories() {
  return message("a list of {}", namesWithCommas(theoryWords()));
}

}  // namespace asperity
