// X3P (ISO 25178-72, before it ISO 5436-2): a ZIP archive with `main.xml`, which contains the
// heights as a list or names a binary file of them, in metres. Of the feature types, profiles (PRF)
// and surfaces (SUR) are read; a point cloud (PCL) has no grid.
#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/base/file_digest.h"
#include "core/base/number_text.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/measured/byte_reader.h"
#include "core/measured/surface_draft.h"
#include "core/measured/uniform_positions.h"
#include "core/measured/zip_archive.h"

namespace asperity {
namespace {

// ---- main.xml ----------------------------------------------------------------------------------

/// Returns the part of a name after its namespace.
std::string_view plainName(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node findChild(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node child : node.children())
    if (plainName(child) == name) return child;
  return {};
}

/// Returns the node at a path such as "Record1/Axes/CX".
pugi::xml_node nodeAt(pugi::xml_node node, std::string_view path) {
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    node = findChild(node, path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return node;
}

std::string_view textAt(const pugi::xml_node& node, std::string_view path) {
  return trimmedBlanks(nodeAt(node, path).child_value());
}

struct X3pAxis {
  bool isIncremental = false;
  char type = 'D';  // of its numbers: I, L, F, D
  bool hasIncrement = false;
  double increment = 1, offset = 0;

  const StoredType& stored() const {
    return type == 'I'   ? kStored<std::int16_t>
           : type == 'L' ? kStored<std::int32_t>
           : type == 'F' ? kStored<float>
                         : kStored<double>;
  }
  bool isWhole() const { return type == 'I' || type == 'L'; }
};

/// mayBeZero: an increment of 0 is none, as across a profile.
X3pAxis readAxis(const SurfaceSource& source, const pugi::xml_node& root, const std::string& name,
                 bool mayBeZero = false) {
  const pugi::xml_node node = nodeAt(root, "Record1/Axes/" + name);
  if (!node) source.fail(message("main.xml has no {}", "Record1/Axes/" + name));
  X3pAxis axis;
  const std::string_view kind = textAt(node, "AxisType");
  if (kind != "I" && kind != "A")
    source.fail(message("main.xml: {} is neither {}", name + "/AxisType", "I, A"));
  axis.isIncremental = kind == "I";
  const std::string_view type = textAt(node, "DataType");
  if (type.size() > 1 ||
      (!type.empty() && std::string_view("ILFD").find(type) == std::string_view::npos))
    source.fail(message("main.xml: {} is neither {}", name + "/DataType", "I, L, F, D"));
  if (!type.empty()) axis.type = type.front();
  const auto number = [&](std::string_view key, double& value) {
    const std::string_view text = textAt(node, key);
    if (text.empty()) return false;
    const Field field = readField(text, '.');
    // Some programs write NaN for "none".
    if (field.kind == FieldKind::Missing) return false;
    if (field.kind != FieldKind::Number)
      source.fail(message("main.xml: {} is not a number", name + "/" + std::string(key)));
    value = field.value;
    return true;
  };
  axis.hasIncrement = number("Increment", axis.increment);
  number("Offset", axis.offset);
  if (axis.increment == 0 && mayBeZero) axis.hasIncrement = false;
  if (axis.isIncremental && axis.increment == 0 && !mayBeZero)
    source.fail(message("main.xml: {} is not a number above 0", name + "/Increment"));
  // The whole numbers of an absolute axis count its increments; for other axes the increment has no
  // meaning.
  if (axis.increment == 0) axis.increment = 1;
  return axis;
}

std::int64_t sizeAt(const SurfaceSource& source, const pugi::xml_node& root,
                    const std::string& path) {
  std::int64_t value = 0;
  if (!readNumber(textAt(root, path), value) || value < 1)
    source.fail(message("main.xml: {} is not a number above 0", path));
  return value;
}

// ---- Points ------------------------------------------------------------------------------------

/// All coordinates of all points; those of an incremental axis are not stored.
struct Points {
  std::vector<double> x, y, z;
};

class X3pReader {
 public:
  explicit X3pReader(const SurfaceSource& source) : source_(source), archive_(source) {}

  SurfaceDraft read() {
    parse();
    const std::string_view feature = textAt(root_, "Record1/FeatureType");
    if (feature == "PCL")
      source_.fail("is a cloud of points (PCL); only profiles and surfaces on a grid are read");
    if (feature != "SUR" && feature != "PRF")
      source_.fail(message("main.xml: {} is neither {}", "FeatureType", "PRF, SUR"));
    const bool isProfile = feature == "PRF";
    axes_ = {readAxis(source_, root_, "CX"), readAxis(source_, root_, "CY", isProfile),
             readAxis(source_, root_, "CZ")};
    noteRotation();
    readSizes(isProfile);
    const auto count = static_cast<std::size_t>(columns_ * rows_);
    if (nodeAt(root_, "Record3/DataLink"))
      readBinary(count);
    else if (nodeAt(root_, "Record3/DataList"))
      readList(count);
    else
      source_.fail(message("main.xml has no {}", "Record3/DataLink"));
    return draft();
  }

 private:
  static constexpr std::uint64_t kSmall = std::uint64_t{1} << 24;
  static constexpr std::uint64_t kMaxPacking = 100;  // of a list of numbers as text

  void parse() {
    // Lists of numbers may be long; a text that is packed more tightly than they can be is none.
    const std::uint64_t limit = std::min<std::uint64_t>(kSmall + kMaxPacking * source_.bytes.size(),
                                                        std::uint64_t{1} << 30);
    // Spreadsheets and arrays of NumPy are ZIP archives as well.
    const bool isMeant = source_.choices.format != "auto" ||
                         source_.bytes.find("main.xml") != std::string_view::npos;
    folder_ = archive_.folderOf("main.xml");
    if (!archive_.has(pathOf("main.xml")) && !isMeant) refuseKind(source_);
    xml_ = archive_.read(pathOf("main.xml"), limit);
    checkMain();
    const pugi::xml_parse_result parsed =
        document_.load_buffer_inplace(xml_.data(), xml_.size(), pugi::parse_default);
    if (!parsed) source_.fail(message("main.xml: byte {}: is not valid XML", parsed.offset));
    root_ = document_.document_element();
    if (plainName(root_) != "ISO5436_2") source_.fail(message("main.xml has no {}", "ISO5436_2"));
  }

  /// Returns the path of a file in the archive: some programs pack a folder and not what is in it.
  std::string pathOf(const std::string& file) const { return folder_ + file; }

  /// Checks main.xml against its checksum, which another file has as "md5 *main.xml".
  void checkMain() {
    if (!archive_.has(pathOf("md5checksum.hex"))) return;
    const std::string text = archive_.read(pathOf("md5checksum.hex"), kSmall);
    requireMd5(trimmedBlanks(text), xml_, "main.xml");
  }

  void requireMd5(std::string_view stated, std::string_view bytes, const std::string& file) const {
    constexpr std::size_t kDigits = 32;
    stated = stated.substr(0, std::min(stated.find_first_of(" \t\r\n*"), stated.size()));
    if (stated.empty()) return;
    if (stated.size() != kDigits || lowerCase(stated) != md5(bytes))
      source_.fail(message("'{}' in its archive does not have the MD5 that the file states",
                           shortened(file)));
  }

  /// Adds a note on axes that the file turns. Heights and positions stay as they are stored.
  void noteRotation() {
    constexpr double kRounding = 1e-6;
    const pugi::xml_node rotation = nodeAt(root_, "Record1/Axes/Rotation");
    bool isTurned = false;
    double upwards = 1;
    for (const char row : {'1', '2', '3'})
      for (const char column : {'1', '2', '3'}) {
        double value = row == column ? 1 : 0;
        const double same = value;
        readTextNumber(textAt(rotation, std::string{'r', row, column}), '.', value);
        isTurned = isTurned || !(std::abs(value - same) <= kRounding);
        if (row == '3' && column == '3') upwards = value;
      }
    if (!isTurned) return;
    notes_.emplace_back(
        "The file turns its axes (Rotation in main.xml). The program does not: it takes heights "
        "and positions as they are stored.");
    if (std::isless(upwards, 0))
      notes_.emplace_back(
          "Turned so, its heights would count downwards: surface.contact_side valleys then chooses "
          "the summits.");
  }

  void readSizes(bool isProfile) {
    const pugi::xml_node matrix = nodeAt(root_, "Record3/MatrixDimension");
    if (matrix) {
      columns_ = sizeAt(source_, root_, "Record3/MatrixDimension/SizeX");
      rows_ = sizeAt(source_, root_, "Record3/MatrixDimension/SizeY");
      const std::int64_t layers = sizeAt(source_, root_, "Record3/MatrixDimension/SizeZ");
      // A row of profiles is N x 1 x M.
      if (isProfile && rows_ == 1) rows_ = layers;
      if (!isProfile && layers > 1) {
        notes_.push_back(message("The first of {} layers is read.", layers));
        layers_ = layers;
      }
    } else if (nodeAt(root_, "Record3/ListDimension")) {
      if (!isProfile)
        source_.fail(
            "is a list of points without a grid; only profiles and surfaces on a grid are read");
      columns_ = sizeAt(source_, root_, "Record3/ListDimension");
      rows_ = 1;
    } else {
      source_.fail(message("main.xml has no {}", "Record3/MatrixDimension"));
    }
    requireSize(source_, columns_, rows_, 0, 0);
  }

  /// Returns the bytes of one point: the numbers of its absolute axes.
  std::size_t stride() const {
    std::size_t bytes = 0;
    for (const X3pAxis& axis : axes_)
      bytes += axis.isIncremental && &axis != &axes_[2] ? 0 : axis.stored().size;
    return bytes;
  }

  void readBinary(std::size_t count) {
    const std::string file(textAt(root_, "Record3/DataLink/PointDataLink"));
    const std::uint64_t all = static_cast<std::uint64_t>(count) * stride();
    if (file.empty()) source_.fail(message("main.xml has no {}", "PointDataLink"));
    // Only the first layer is read.
    const std::string bytes = archive_.read(
        pathOf(file), all * static_cast<std::uint64_t>(std::min<std::int64_t>(layers_, 64)));
    if (bytes.size() < all)
      source_.fail(message("ends too early: {} bytes are needed from byte {} on, and {} are there",
                           all, 0, bytes.size()));
    requireMd5(textAt(root_, "Record3/DataLink/MD5ChecksumPointData"), bytes, file);
    ByteReader reader(source_, bytes);
    for (std::size_t i = 0; i < count; ++i) {
      source_.reportPoint(i, count);
      takePoint(reader);
    }
    takeMask(count);
  }

  void takePoint(ByteReader& reader) {
    std::array<std::vector<double>*, 3> parts{&points_.x, &points_.y, &points_.z};
    for (std::size_t k = 0; k < 3; ++k)
      if (!axes_[k].isIncremental || k == 2)
        parts[k]->push_back(scaled(k, reader.read(axes_[k].stored())));
  }

  /// Returns a number of an axis in metres; NaN stays NaN.
  double scaled(std::size_t axis, double value) const {
    if (std::isnan(value)) return value;
    const bool counts = axes_[axis].isIncremental || axes_[axis].isWhole();
    const double metres = counts ? value * axes_[axis].increment : value;
    return std::isfinite(metres) ? metres : kMissingHeight;
  }

  /// Applies the file of valid points: one bit for each point, the lowest bit of a byte first, 0
  /// where it was not measured.
  void takeMask(std::size_t count) {
    const std::string file(textAt(root_, "Record3/DataLink/ValidPointsLink"));
    if (file.empty()) return;
    if (!archive_.has(pathOf(file))) {
      // Some programs name the file but write none where all points are valid.
      if (textAt(root_, "Record3/DataLink/MD5ChecksumValidPoints").empty()) return;
      source_.fail(message("has no file '{}' in its archive", shortened(file)));
    }
    const std::string bits = archive_.read(pathOf(file), count / 8 + 1024);
    requireMd5(textAt(root_, "Record3/DataLink/MD5ChecksumValidPoints"), bits, file);
    if (bits.size() < (count + 7) / 8)
      source_.fail(message("ends too early: {} bytes are needed from byte {} on, and {} are there",
                           (count + 7) / 8, 0, bits.size()));
    for (std::size_t i = 0; i < count; ++i)
      if ((static_cast<unsigned char>(bits[i / 8]) >> (i % 8) & 1) == 0)
        points_.z[i] = kMissingHeight;
  }

  /// Reads <Datum>z</Datum> or <Datum>x;y;z</Datum>; an empty datum was not measured.
  void readList(std::size_t count) {
    const pugi::xml_node list = nodeAt(root_, "Record3/DataList");
    std::vector<std::size_t> stored;
    for (std::size_t k = 0; k < 3; ++k)
      if (!axes_[k].isIncremental || k == 2) stored.push_back(k);
    std::array<std::vector<double>*, 3> parts{&points_.x, &points_.y, &points_.z};
    for (const pugi::xml_node datum : list.children()) {
      if (plainName(datum) != "Datum") continue;
      if (points_.z.size() == count) break;
      std::string_view text = trimmedBlanks(datum.child_value());
      const bool isEmpty = text.empty();
      // Some programs write all three coordinates, whatever the axes are.
      const auto fields = static_cast<std::size_t>(std::ranges::count(text, ';')) + 1;
      const bool isWhole = fields == 3 && stored.size() < 3;
      if (!isEmpty && fields != stored.size() && !isWhole)
        source_.fail(message("main.xml: datum {} has {} numbers where {} are needed",
                             points_.z.size() + 1, fields, stored.size()));
      for (std::size_t i = 0, k = 0; i < (isEmpty ? stored.size() : fields); ++i) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const Field field = readField(text.substr(0, end), '.');
        text.remove_prefix(std::min(end + 1, text.size()));
        if (field.kind == FieldKind::Text || field.kind == FieldKind::Flag)
          source_.fail(message("main.xml: datum {} is not a number", points_.z.size() + 1));
        const std::size_t axis = isWhole ? i : stored[i];
        if (k < stored.size() && stored[k] == axis) {
          parts[axis]->push_back(scaled(axis, field.value));
          ++k;
        }
      }
      if (points_.z.size() % 65536 == 0) source_.report(0.5);
    }
    if (points_.z.size() < count)
      source_.fail(message("main.xml: has {} points where {} are needed", points_.z.size(), count));
  }

  SurfaceDraft draft() {
    SurfaceDraft made;
    made.facts.notes = std::move(notes_);
    made.positionUnit = made.heightUnit = StatedUnit{"m", 1};
    Topography& grid = made.grid;
    grid = {columns_, rows_, std::abs(axes_[0].increment), std::abs(axes_[1].increment),
            std::move(points_.z)};
    if (axes_[0].isIncremental && !axes_[0].hasIncrement) {
      made.hasPositions = false;
      made.positionUnit.reset();
    }
    if (rows_ == 1) {
      // The positions of a profile are stored, and may be anything.
      if (!axes_[0].isIncremental)
        resampleUniformly(points_.x, std::move(grid.height), {}, source_, made);
      return made;
    }
    const auto width = static_cast<std::size_t>(columns_);
    if (!axes_[0].isIncremental) {
      std::vector<double> x(points_.x.begin(),
                            points_.x.begin() + static_cast<std::ptrdiff_t>(width));
      grid.columnSpacing = requireUniform(x, "CX");
    }
    if (!axes_[1].isIncremental) {
      std::vector<double> y;
      for (std::size_t i = 0; i < points_.y.size(); i += width) y.push_back(points_.y[i]);
      grid.rowSpacing = requireUniform(y, "CY");
    } else if (!axes_[1].hasIncrement) {
      grid.rowSpacing = made.hasPositions ? 0 : grid.columnSpacing;
    }
    return made;
  }

  double requireUniform(const std::vector<double>& positions, std::string_view axis) const {
    const auto spacing = uniformSpacing(positions);
    if (!spacing)
      source_.fail(
          message("the positions along {} are not uniform; surfaces need a uniform grid", axis));
    return *spacing;
  }

  const SurfaceSource& source_;
  ZipArchive archive_;
  std::string folder_;  // of all files
  std::string xml_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::array<X3pAxis, 3> axes_{};
  std::int64_t columns_ = 0, rows_ = 0, layers_ = 1;
  Points points_;
  std::vector<Message> notes_;
};

}  // namespace

bool isX3p(const SurfaceSource& source) {
  return source.bytes.starts_with("PK\3\4") || source.bytes.starts_with("PK\5\6");
}

SurfaceDraft readX3p(const SurfaceSource& source) {
  return X3pReader(source).read();
}

}  // namespace asperity
