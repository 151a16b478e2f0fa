// Gwyddion's native format: "GWYP" and a tree of objects, each a name, a size and named components
// of typed values, little-endian (Gwyddion user guide, "Gwyddion Native File (.gwy)"). A channel is
// the GwyDataField "/N/data" of the outermost container.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"

namespace asperity {
namespace {

constexpr std::string_view kGwyMagic = "GWYP";

struct Component {
  std::string_view name;
  char type = 0;
  std::string_view
      value;              // the bytes of a value; of a text without its end; of an object all of it
  std::size_t count = 1;  // of an array
};

/// Takes the text up to the next zero byte.
std::string_view takeText(const SurfaceSource& source, ByteReader& reader, std::string_view bytes) {
  const std::size_t end = bytes.find('\0', reader.position());
  if (end == std::string_view::npos)
    source.fail(message("byte {}: the text has no end", reader.position()));
  const std::string_view text = reader.take(end - reader.position());
  reader.skip(1);
  return text;
}

/// An object: its name and the bytes of its components.
struct Object {
  std::string_view name;
  std::string_view components;
};

Object readObject(const SurfaceSource& source, std::string_view bytes) {
  ByteReader reader(source, bytes);
  Object object;
  object.name = takeText(source, reader, bytes);
  const auto size = reader.read<std::uint32_t>();
  object.components = reader.take(size);
  return object;
}

/// Returns the size of a single value; 0 of texts and objects.
std::size_t valueSize(const SurfaceSource& source, char type) {
  switch (type) {
    case 'b':
    case 'c':
    case 'C':
      return 1;
    case 'i':
    case 'I':
      return 4;
    case 'q':
    case 'Q':
    case 'd':
    case 'D':
      return 8;
    case 's':
    case 'S':
    case 'o':
    case 'O':
      return 0;
    default:
      source.fail(message("{} {} is not known", "component type", static_cast<int>(type)));
  }
}

/// Skips `count` texts or objects and returns their bytes.
std::string_view takeUnsized(const SurfaceSource& source, ByteReader& reader,
                             std::string_view bytes, char type, std::size_t count) {
  const std::size_t begin = reader.position();
  for (std::size_t i = 0; i < count; ++i) {
    takeText(source, reader, bytes);
    if (type == 'o' || type == 'O') reader.skip(reader.read<std::uint32_t>());
  }
  return bytes.substr(begin, reader.position() - begin);
}

std::vector<Component> readComponents(const SurfaceSource& source, std::string_view bytes) {
  std::vector<Component> components;
  ByteReader reader(source, bytes);
  while (!reader.atEnd()) {
    Component one;
    one.name = takeText(source, reader, bytes);
    one.type = reader.read<char>();
    const std::size_t size = valueSize(source, one.type);
    const bool isArray = one.type >= 'A' && one.type <= 'Z';
    if (isArray) one.count = reader.read<std::uint32_t>();
    one.value = size > 0 ? reader.take(size * one.count)
                         : takeUnsized(source, reader, bytes, one.type, one.count);
    if (one.type == 's') one.value = one.value.substr(0, one.value.find('\0'));
    components.push_back(one);
  }
  return components;
}

const Component* find(const std::vector<Component>& components, std::string_view name, char type) {
  const auto found = std::ranges::find_if(
      components, [&](const Component& one) { return one.name == name && one.type == type; });
  return found == components.end() ? nullptr : &*found;
}

struct DataField {
  std::int64_t columns = 0, rows = 0;
  double width = 1, height = 1;
  std::string positionUnit{}, heightUnit{};
  std::string_view data;
};

std::string readUnit(const SurfaceSource& source, const std::vector<Component>& components,
                     std::string_view name) {
  const Component* unit = find(components, name, 'o');
  if (unit == nullptr) return {};
  const std::vector<Component> parts =
      readComponents(source, readObject(source, unit->value).components);
  const Component* text = find(parts, "unitstr", 's');
  return text == nullptr ? std::string() : std::string(text->value);
}

DataField readDataField(const SurfaceSource& source, const Component& channel) {
  const Object object = readObject(source, channel.value);
  if (object.name != "GwyDataField") source.failWithout("GwyDataField");
  const std::vector<Component> components = readComponents(source, object.components);
  const auto need = [&](std::string_view name, char type) -> const Component& {
    const Component* found = find(components, name, type);
    if (found == nullptr) source.failWithout(name);
    return *found;
  };
  DataField field;
  field.columns = storedNumber<std::int32_t>(need("xres", 'i').value);
  field.rows = storedNumber<std::int32_t>(need("yres", 'i').value);
  if (const Component* size = find(components, "xreal", 'd'))
    field.width = storedNumber<double>(size->value);
  if (const Component* size = find(components, "yreal", 'd'))
    field.height = storedNumber<double>(size->value);
  field.positionUnit = readUnit(source, components, "si_unit_xy");
  field.heightUnit = readUnit(source, components, "si_unit_z");
  field.data = need("data", 'D').value;
  for (const auto& [name, count] : {std::pair("xres", field.columns), {"yres", field.rows}})
    if (count < 1) source.failNotAboveZero(name);
  requireSize(source, field.columns, field.rows, field.data.size(), sizeof(double));
  return field;
}

struct Channel {
  std::int64_t number = 0;  // of "/number/data"
  const Component* component = nullptr;
};

/// Returns the channels in the order of their numbers.
std::vector<Channel> findChannels(const std::vector<Component>& components) {
  std::vector<Channel> channels;
  for (const Component& one : components) {
    if (one.type != 'o' || !one.name.starts_with('/') || !one.name.ends_with("/data")) continue;
    const std::string_view number = one.name.substr(1, one.name.size() - 6);
    if (Channel channel{0, &one}; readNumber(number, channel.number)) channels.push_back(channel);
  }
  std::ranges::stable_sort(channels, {}, &Channel::number);
  return channels;
}

std::string channelTitle(const std::vector<Component>& components, const Channel& channel) {
  const std::string key = "/" + std::to_string(channel.number) + "/data/title";
  const Component* title = find(components, key, 's');
  return title == nullptr ? "/" + std::to_string(channel.number) + "/data"
                          : std::string(title->value);
}

/// Returns whether a title is that of a quantity that is a length and no height, as a microscope
/// with a vibrating tip measures it beside heights.
bool isOtherLength(std::string_view title) {
  constexpr WordList kOthers(
      "amplitude error deflection deformation indentation phase adhesion dissipation");
  return containsOneOf(lowerCase(title), kOthers);
}

/// Returns the channel that the user chooses, or the first one whose values are lengths and, by
/// its title, may be heights.
const Channel& chosen(const SurfaceSource& source, const std::vector<Component>& components,
                      const std::vector<Channel>& channels) {
  if (source.choices.heightColumn > 0) {
    if (static_cast<std::size_t>(source.choices.heightColumn) > channels.size())
      throw InputError(source.name, "surface.height_column",
                       message("the file has {} channels", channels.size()));
    return channels[static_cast<std::size_t>(source.choices.heightColumn - 1)];
  }
  const auto isHeight = [&source](const Channel& channel) {
    return metresPer(readDataField(source, *channel.component).heightUnit).has_value();
  };
  const auto mayBeHeight = [&](const Channel& channel) {
    return isHeight(channel) && !isOtherLength(channelTitle(components, channel));
  };
  auto found = std::ranges::find_if(channels, mayBeHeight);
  if (found == channels.end()) found = std::ranges::find_if(channels, isHeight);
  return found == channels.end() ? channels.front() : *found;
}

/// masksAreGaps: masked points were not measured, as in the files that Gwyddion makes of other
/// formats.
SurfaceDraft readGwyFile(const SurfaceSource& source, bool masksAreGaps) {
  if (!isGwy(source)) source.fail(message("is not a {} file", "GWY"));
  const Object container = readObject(source, source.bytes.substr(kGwyMagic.size()));
  const std::vector<Component> components = readComponents(source, container.components);
  const std::vector<Channel> channels = findChannels(components);
  if (channels.empty()) source.fail("has no channel of heights");
  const Channel& channel = chosen(source, components, channels);
  const DataField field = readDataField(source, *channel.component);

  SurfaceDraft draft;
  draft.facts.heightColumn = shortened(channelTitle(components, channel));
  if (channels.size() > 1)
    draft.facts.notes.push_back(
        message("The channel '{}' is read, the file has {}; surface.height_column chooses another.",
                draft.facts.heightColumn, channels.size()));
  Topography& grid = draft.grid;
  grid = {field.columns,
          field.rows,
          field.width / static_cast<double>(field.columns),
          field.height / static_cast<double>(field.rows),
          {}};
  draft.positionUnit = statedUnit(source, "xy", field.positionUnit);
  draft.heightUnit = statedUnit(source, "z", field.heightUnit);
  const auto points = static_cast<std::size_t>(field.columns * field.rows);
  takeHeights(source, {.bytes = field.data, .type = kStored<double>}, grid);

  const Component* mask = find(components, "/" + std::to_string(channel.number) + "/mask", 'o');
  if (mask == nullptr) return draft;
  if (!masksAreGaps) {
    draft.facts.notes.push_back("The channel has a mask, which is not used.");
    return draft;
  }
  const DataField masked = readDataField(source, *mask);
  if (masked.columns != field.columns || masked.rows != field.rows) return draft;
  for (std::size_t i = 0; i < points; ++i) {
    const auto value = storedNumber<double>(masked.data.substr(i * sizeof(double)));
    if (!std::isnan(value) && value > 0.5) grid.height[i] = kMissingHeight;
  }
  return draft;
}

}  // namespace

bool isGwy(const SurfaceSource& source) {
  return source.bytes.starts_with(kGwyMagic);
}

SurfaceDraft readGwy(const SurfaceSource& source) {
  return readGwyFile(source, false);
}

SurfaceDraft readConvertedGwy(const SurfaceSource& source) {
  return readGwyFile(source, true);
}

}  // namespace asperity
