// Lists of a scene as JSON text: the arms of an elastomer,
// [{"modulus":1e7,"relaxation_time":0.001}, ...], a table of temperature shifts,
// [{"temperature":293.15,"log10_shift":0}, ...], tables of measured friction, and theories.
// Pure functions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/scene/scene.h"

namespace asperity {

/// One number of a list's row: the table of parameters within the list.
template <class Row>
struct ListMember {
  const char* name;
  double Row::*value;
  double least, most;
  const char* unit;
};
using ArmMember = ListMember<Arm>;

/// Returns modulus, then relaxation time.
std::span<const ArmMember> armMembers();

/// Returns temperature, then log10 of the shift.
std::span<const ListMember<ShiftPoint>> shiftMembers();

/// Reads a list. Throws InputError that names the member, such as KEY[1].modulus.
std::vector<Arm> parseArms(std::string_view json, const std::string& key);

/// Reads a table of shifts, whose temperatures must rise from row to row.
std::vector<ShiftPoint> parseShiftTable(std::string_view json, const std::string& key);

/// Returns JSON text with numbers in the shortest form that reads back to the same value.
std::string listText(const std::vector<Arm>& arms);
std::string listText(const std::vector<ShiftPoint>& table);

/// Read and write tables of measured friction: [{"file": "mine.csv", "label": "compound A"}, ...].
inline constexpr std::size_t kMaxDataFiles = 32;
std::vector<DataFile> parseDataFiles(std::string_view json, const std::string& key);
std::string listText(const std::vector<DataFile>& files);

/// Return the words of theories, and read and write a list of them: ["eq_11",
/// "persson_half_space"]; each occurs once.
std::span<const std::string_view> theoryWords();
std::vector<Theory> parseTheories(std::string_view json, const std::string& key);
std::string listText(const std::vector<Theory>& theories);

/// Returns in words what a list may contain.
Message allowedArms();
Message allowedShiftTable();
Message allowedDataFiles();
Message allowedTheories();

}  // namespace asperity
