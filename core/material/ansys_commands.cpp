// Commands of Ansys (Mechanical APDL Command Reference): TB,PRONY and TB,SHIFT, and the modulus of
// the same material by TB,HYPER, TB,ELASTIC, MP or MPDATA. All of these moduli are instantaneous.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/text_number.h"
#include "core/material/dma_columns.h"
#include "core/material/prony_keywords.h"

namespace asperity {
namespace {

/// Values of one property or table, a row for each temperature.
struct AnsysTable {
  TemperatureRows rows{};
  std::vector<std::vector<double>> data{};
  std::vector<std::size_t> lines{};  // of the last data of each row
  std::size_t next = 0;              // the place after the last constant
  std::string option{};              // "neo"

  /// Returns a constant of a row, counted from 0. Throws InputError where there is none.
  double constant(std::size_t row, std::size_t index) const {
    if (index >= data[row].size() || !std::isfinite(data[row][index]))
      rows.line.fail(message("has no constant {}", index + 1));
    return data[row][index];
  }
};

/// Returns the letters that Ansys compares: "hype" for "hyper".
std::string significant(const std::string& word) {
  return word.substr(0, 4);
}

/// Returns the material of a field, "2" for "2." as well; blank and 0 mean the default.
std::string materialNumber(const std::string& word, const std::string& usual) {
  double number = 0;
  if (word.empty()) return usual;
  if (!readTextNumber(word, '.', number)) return word;
  return number == 0 ? usual : plainNumber(number);
}

/// Reads the commands in their order, all of them or those of one material.
class AnsysReader {
 public:
  explicit AnsysReader(const KeywordFile& file) : file_(file) {
    for (const KeywordLine& line : file.lines) {
      KeywordLine command = line;
      // ! begins a comment.
      for (std::size_t i = 0; i < command.words.size(); ++i)
        if (const std::size_t mark = command.words[i].find('!'); mark != std::string::npos) {
          command.words[i].resize(mark);
          command.words.resize(i + 1);
        }
      // Files that Ansys itself writes have a release and a number of values before the fields.
      const std::string name = significant(command.words.front());
      const std::string release = command.word(1);
      if ((name == "mpda" || name == "mpte") && release.size() > 1 && release.front() == 'r' &&
          isDigit(release[1]))
        command.words.erase(
            command.words.begin() + 1,
            command.words.begin() + std::min<std::ptrdiff_t>(3, std::ssize(command.words)));
      commands_.push_back(std::move(command));
    }
  }

  /// Returns the material of TB,PRONY; nothing where there is none. Throws InputError where several
  /// have one.
  std::optional<std::string> findMaterial() {
    std::optional<std::string> material;
    bool hasShear = false;
    std::string current = "1";
    for (const KeywordLine& line : commands_) {
      const std::string name = line.words.front();
      if (name == "mat") current = materialNumber(line.word(1), "1");
      if (name == "mp" || significant(name) == "mpda")
        materials_.insert(materialNumber(line.word(2), current));
      if (name != "tb") continue;
      const std::string own = materialNumber(line.word(2), "1");
      materials_.insert(own);
      if (significant(line.word(1)) != "pron") continue;
      const bool isShear = line.word(5) != "bulk";
      if (isShear && hasShear)
        line.fail("is a second TB,PRONY; keep the material that is meant alone");
      if (isShear || !material) material = own;
      hasShear = hasShear || isShear;
    }
    return material;
  }

  void read(const std::string& material) {
    std::string current = "1";
    AnsysTable* table = nullptr;
    for (const KeywordLine& line : commands_) {
      const std::string& name = line.words.front();
      if (name == "mat") current = materialNumber(line.word(1), "1");
      if (name == "tb") {
        table = materialNumber(line.word(2), "1") == material ? openTable(line) : nullptr;
      } else if (table && significant(name) == "tbte") {
        openRow(line, *table);
      } else if (table && significant(name) == "tbda") {
        addData(line, *table);
      } else if (significant(name) == "mpte") {
        setTemperatures(line);
      } else if (name == "mp" && materialNumber(line.word(2), current) == material) {
        addProperty(line);
      } else if (significant(name) == "mpda" && materialNumber(line.word(2), current) == material) {
        addProperties(line);
      }
    }
    // A temperature without data is no row.
    for (auto& [label, filled] : tables_)
      for (std::size_t i = filled.data.size(); i-- > 0;)
        if (filled.data[i].empty()) {
          const auto at = static_cast<std::ptrdiff_t>(i);
          filled.data.erase(filled.data.begin() + at);
          filled.lines.erase(filled.lines.begin() + at);
          filled.rows.temperatures.erase(filled.rows.temperatures.begin() + at);
        }
  }

  /// Returns a table or property that has a row; null elsewhere.
  const AnsysTable* find(const std::string& label) const {
    const auto found = tables_.find(label);
    return found != tables_.end() && !found->second.data.empty() ? &found->second : nullptr;
  }

  std::size_t materials() const { return materials_.size(); }
  const std::vector<Message>& notes() const { return notes_; }
  std::optional<double> absoluteZero() const {
    for (const KeywordLine& line : commands_)
      if (significant(line.words.front()) == "toff") return -line.numberAt(1);
    return {};
  }

 private:
  /// Returns the table that TB opens; null where it is not read.
  AnsysTable* openTable(const KeywordLine& line) {
    const std::string label = significant(line.word(1)), option = significant(line.word(5));
    const bool isRead = (label == "pron" && option != "bulk") ||
                        (label == "shif" && option == "wlf") ||
                        ((label == "hype" || label == "elas") && file_.hasModulus);
    if (label == "shif" && !isRead) notes_.push_back(shiftLeftOut("tb,shift," + line.word(5)));
    if (!isRead) return nullptr;
    if (tables_.contains(label)) refuseSecond(line);
    AnsysTable& table = tables_[label];
    table.rows.line = line;
    table.option = option;
    return &table;
  }

  void openRow(const KeywordLine& line, AnsysTable& table) const {
    const std::optional<double> temperature = line.optionalNumberAt(1);
    if (std::ranges::find(table.rows.temperatures, temperature) != table.rows.temperatures.end())
      line.fail("is a second TBTEMP of the same temperature; keep the one that is meant");
    table.rows.temperatures.push_back(temperature);
    table.data.emplace_back();
    table.lines.push_back(line.number);
    table.next = 0;
  }

  void addData(const KeywordLine& line, AnsysTable& table) const {
    const double start = line.optionalNumberAt(1).value_or(static_cast<double>(table.next + 1));
    if (!(start >= 1 && start <= 200)) line.fail("begins at a place that is outside 1 to 200");
    if (table.data.empty()) {
      table.rows.temperatures.emplace_back();
      table.data.emplace_back();
      table.lines.push_back(line.number);
    }
    std::vector<double>& data = table.data.back();
    table.lines.back() = line.number;
    auto index = static_cast<std::size_t>(start) - 1;
    for (std::size_t i = 2; i < line.words.size(); ++i, ++index) {
      if (line.words[i].empty()) continue;
      data.resize(std::max(data.size(), index + 1), RawSeries::kNotStated);
      data[index] = line.numberAt(i);
      table.next = index + 1;
    }
  }

  /// MPTEMP alone forgets the temperatures of MPDATA.
  void setTemperatures(const KeywordLine& line) {
    if (line.words.size() < 3) {
      temperatures_.clear();
      return;
    }
    std::size_t index = firstPlace(line, 1);
    for (std::size_t i = 2; i < line.words.size(); ++i, ++index) {
      if (line.words[i].empty()) continue;
      temperatures_.resize(std::max(temperatures_.size(), index + 1));
      temperatures_[index] = line.numberAt(i);
    }
  }

  bool isProperty(const std::string& label) const {
    return file_.hasModulus &&
           (label == "ex" || label == "nuxy" || label == "prxy" || label == "gxy");
  }

  void addProperty(const KeywordLine& line) {
    if (!isProperty(line.word(1))) return;
    for (std::size_t i = 4; i < line.words.size(); ++i)
      if (!line.words[i].empty() && line.numberAt(i) != 0)
        line.fail(
            "changes with temperature as a polynomial, which is not read; write "
            "MPTEMP and MPDATA, or give --instantaneous-modulus");
    AnsysTable& table = property(line);
    if (!table.data.empty()) refuseSecond(line);
    table.rows.temperatures.emplace_back();
    table.data.push_back({line.numberAt(3)});
  }

  void addProperties(const KeywordLine& line) {
    if (!isProperty(line.word(1))) return;
    AnsysTable& table = property(line);
    std::size_t index = firstPlace(line, 3);
    for (std::size_t i = 4; i < line.words.size(); ++i, ++index) {
      if (line.words[i].empty()) continue;
      const bool hasTemperature = index < temperatures_.size() && temperatures_[index];
      if (!hasTemperature && !(temperatures_.empty() && index == 0))
        line.fail(
            message("has a value in place {} for which MPTEMP has no temperature", index + 1));
      table.rows.temperatures.push_back(hasTemperature ? temperatures_[index]
                                                       : std::optional<double>());
      table.data.push_back({line.numberAt(i)});
    }
  }

  /// NUXY and PRXY are one: of an isotropic material they are equal.
  AnsysTable& property(const KeywordLine& line) {
    const std::string label = line.word(1);
    AnsysTable& table = tables_[label == "prxy" ? "nuxy" : label];
    if (table.rows.line.number == 0) table.rows.line = line;
    return table;
  }

  std::size_t firstPlace(const KeywordLine& line, std::size_t field) const {
    constexpr double kMax = 1000;
    const double start = line.optionalNumberAt(field).value_or(1);
    if (!(start >= 1 && start <= kMax))
      line.fail(message("begins at a place that is outside 1 to {}", plain(kMax)));
    return static_cast<std::size_t>(start) - 1;
  }

  [[noreturn]] void refuseSecond(const KeywordLine& line) const {
    line.fail("states a property of the same material again; keep the one that is meant");
  }

  const KeywordFile& file_;
  std::vector<KeywordLine> commands_;
  std::set<std::string> materials_;
  std::map<std::string, AnsysTable> tables_;         // by their significant letters
  std::vector<std::optional<double>> temperatures_;  // of MPTEMP
  std::vector<Message> notes_;
};

/// W = mu/2 (I1 - 3) for NEO, and C10 (I1 - 3) + C01 (I2 - 3) + ... for MOONEY and YEOH.
double hyperelasticShear(const AnsysTable& table, std::size_t row) {
  const double first = table.constant(row, 0);
  if (table.option == "neo") return first;
  if (table.option == "yeoh") return 2 * first;
  if (table.option == "moon") return 2 * (first + table.constant(row, 1));
  table.rows.line.fail(
      "has a hyperelastic form whose shear modulus is not read; NEO, MOONEY and YEOH "
      "are, or give --instantaneous-modulus");
}

/// Of OELM, OELN, AELS and AELF the second constant is another modulus, not Poisson's ratio.
void requireIsotropic(const AnsysTable& elastic) {
  if (elastic.option.empty() || elastic.option.starts_with("iso")) return;
  elastic.rows.line.fail(
      "has moduli that differ with direction, which are not read; give "
      "--equilibrium-modulus");
}

}  // namespace

std::optional<RawSeries> ansysSeries(const KeywordFile& file) {
  AnsysReader reader(file);
  const std::optional<std::string> material = reader.findMaterial();
  if (!material) return {};
  reader.read(*material);
  RawSeries series;
  series.format = "commands of Ansys";
  series.material = *material;
  series.notes = reader.notes();
  addMaterialNote(series.material, reader.materials(), series);
  const std::optional<double> absoluteZero = reader.absoluteZero();
  if (const AnsysTable* shift = reader.find("shif")) {
    if (shift->data.size() > 1)
      shift->rows.line.fail(
          "has a shift for more than one temperature; keep the one that is meant");
    TemperatureShift wlf;
    wlf.referenceTemperature =
        readReference(shift->constant(0, 0), absoluteZero, file.choices, series);
    wlf.c1 = shift->constant(0, 1);
    wlf.c2 = shift->constant(0, 2);
    series.shift = wlf;
  }
  // The tables that are used: a hyperelastic material does not use its linear moduli.
  const AnsysTable* terms = reader.find("pron");
  const AnsysTable *hyper = reader.find("hype"), *elastic = reader.find("elas");
  const AnsysTable *young = reader.find("ex"), *poisson = reader.find("nuxy");
  const AnsysTable* shear = reader.find("gxy");
  if (hyper) elastic = nullptr;
  if (elastic) requireIsotropic(*elastic);
  if (hyper || elastic) young = nullptr;
  if (!young) poisson = nullptr;
  if (hyper || elastic || young) shear = nullptr;
  std::vector<TemperatureRows> tables;
  std::map<const AnsysTable*, std::size_t> places;
  for (const AnsysTable* table : {terms, hyper, elastic, young, poisson, shear}) {
    if (!table) continue;
    places[table] = tables.size();
    tables.push_back(table->rows);
  }
  const std::vector<std::size_t> chosen = chooseRows(tables, absoluteZero, file, series);
  const auto constant = [&](const AnsysTable& table, std::size_t index) {
    return table.constant(chosen[places[&table]], index);
  };
  if (terms) {
    const std::size_t row = chosen[places[terms]];
    for (std::size_t i = 0; i < terms->data[row].size(); i += 2)
      series.terms.push_back({constant(*terms, i), constant(*terms, i + 1), terms->lines[row]});
  }
  if (hyper) series.instantaneous = hyperelasticShear(*hyper, chosen[places[hyper]]);
  if (elastic) series.instantaneous = shearFromYoungs(constant(*elastic, 0), constant(*elastic, 1));
  if (young)
    series.instantaneous =
        shearFromYoungs(constant(*young, 0), poisson ? constant(*poisson, 0) : 0.5);
  if (shear) series.instantaneous = constant(*shear, 0);
  return series;
}

}  // namespace asperity
