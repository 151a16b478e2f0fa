// The rows of the panel of parameters under headings that fold: which rows exist, in which order
// they stand, and which of them are visible. A row is made when a scene needs it for the first
// time: most of the table has no meaning for a given scene, and making rows is a large part of the
// time in which a window is made. The list holds no scene, and what a user enters is for its panel,
// which hears of each new row. GUI thread.
#pragma once

#include <QMap>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

class QLabel;
class QVBoxLayout;

namespace asperity {

class ParameterRow;
class SectionHeader;
struct Parameter;

/// Rows under one heading, in this order. `title` is asked again for another language; without it
/// the rows have no heading. A group with a name can be folded, and the name outlives versions of
/// the program in the settings.
struct ParameterGroup {
  std::function<QString()> title;
  std::vector<std::string_view> keys;
  QString name{};
};

/// Returns all rows of the table under their headings: frequently used ones first; unknown ones
/// follow in the order of the table.
std::vector<ParameterGroup> parameterSections();

/// The access of the user to a row.
enum class RowAccess { Free, Locked, Hidden };

/// The rows that are chosen among those of a scene.
struct RowChoice {
  bool isWhole = true;  // all, not only the essential ones
  QStringList words{};  // of the filter
  QString revealed{};   // key of a row that is visible in any case
};

class RowList : public QWidget {
  Q_OBJECT

 public:
  explicit RowList(const std::vector<ParameterGroup>& groups, QWidget* parent = nullptr);

  /// Makes the rows that the scene needs and that do not exist yet. Gives the ends of the curve's
  /// axis the unit and the slider of its key, and the velocity the name that it has in the scene's
  /// motion.
  void prepareFor(const Scene& scene);

  /// Returns the rows that exist, by key.
  const QMap<QString, ParameterRow*>& rows() const { return rows_; }
  /// Returns null where no scene needed the row so far.
  ParameterRow* row(std::string_view key) const;
  /// Returns the first visible row; null without one.
  ParameterRow* firstVisible() const;

  /// Sets what a user may do with rows; see ParameterPanel::setRowAccess().
  void setAccess(const std::map<std::string, RowAccess>& access);
  const std::map<std::string, RowAccess>& access() const { return access_; }

  /// Names of the folded groups.
  QStringList folded() const;
  void setFolded(const QStringList& names);

  /// Shows and hides rows and headings. A row with something to read below it is visible in any
  /// case.
  void arrange(const Scene& scene, const RowChoice& choice);

  /// Sets all texts.
  void showTexts();

  /// Returns the width in pixels that the rows of a scene need, whether they are visible or not,
  /// but for those that the user has no access to.
  int neededWidth(const Scene& scene) const;

 signals:
  void rowMade(asperity::ParameterRow* row);
  /// Emitted when the user folds or opens a section.
  void foldChanged();

 private:
  struct Section {
    ParameterGroup group;
    QLabel* label = nullptr;            // of a group that does not fold
    SectionHeader* header = nullptr;    // of one that does
    std::vector<ParameterRow*> rows{};  // as far as they exist
  };

  void addHeading(const ParameterGroup& group);
  void showHeadings();
  ParameterRow& makeRow(const Parameter& parameter);
  void updateUnits(const Scene& scene);
  RowAccess accessTo(std::string_view key) const;
  bool isNamed(std::string_view key) const;
  bool mayBeVisible(const ParameterRow& row, const Scene& scene) const;

  QVBoxLayout* column_;
  std::vector<Section> sections_;
  QMap<QString, ParameterRow*> rows_;
  std::map<std::string, RowAccess> access_;
  std::string axis_;  // the swept key, in whose unit the ends of the axis are shown
  QLabel* noMatch_;   // shown where no row is visible
};

}  // namespace asperity
