// The panel of parameters, generated from the table: one ParameterRow for each row, grouped by
// section, in a scroll area. It owns the scene that its controls show; every accepted change makes
// a new scene. A refused text changes nothing, and the reason is shown where it was typed; an
// incomplete scene is kept with a note, but not passed on. GUI thread.
#pragma once

#include <QMap>
#include <QSet>
#include <QWidget>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "ui/panels/profile_defaults.h"
#include "ui/panels/value_entry.h"

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace asperity {

class ParameterRow;
struct Parameter;

/// Asks the user for a file, beginning in a folder; empty where none was chosen.
using FileChooser = std::function<QString(QWidget* parent, const QString& folder)>;

/// Rows under one heading, in this order. `title` is asked again for another language; without it
/// the rows have no heading.
struct ParameterGroup {
  std::function<QString()> title;
  std::vector<std::string_view> keys;
  bool isInFirstRow = true;  // whether the heading is that of a choice that comes first
};

/// What a user may do with a row.
enum class RowAccess { Free, Locked, Hidden };

class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  /// All rows of the table, by section.
  explicit ParameterPanel(const Scene& scene, QWidget* parent = nullptr);
  /// Some rows of the table.
  ParameterPanel(const Scene& scene, const std::vector<ParameterGroup>& groups,
                 QWidget* parent = nullptr);

  const Scene& scene() const { return scene_; }

  /// Shows another scene without emitting a signal.
  void setScene(const Scene& scene);

  /// Shows an error of a parameter that occurred only when the scene ran. Unknown keys are ignored.
  void showError(const QString& key, const QString& text);

  /// Removes such errors, because the scene runs.
  void clearErrors();

  /// Shows values of the present line where the scene takes them from a file.
  void showLine(const LineSize& line);

  /// Sets what a user may do with rows: by key ("load.normal_force") or for all others ("*"). An
  /// empty map frees everything.
  void setRowAccess(const std::map<std::string, RowAccess>& access);

  /// Replaces the usual file dialog.
  void setFileChooser(FileChooser chooser);

  QSize sizeHint() const override;

 signals:
  void sceneEdited(const asperity::Scene& scene);
  /// Emitted where the user wants to open a measured surface, or a material, for this scene.
  void surfaceWanted(const asperity::Scene& scene);
  void materialWanted(const asperity::Scene& scene);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addGroup(QVBoxLayout& column, const ParameterGroup& group);
  ParameterRow& addRow(QVBoxLayout& column, const Parameter& parameter);
  template <class Change>
  void edit(ParameterRow& row, Change&& change, const QString& refusal = {});
  void takeText(ParameterRow& row, const QString& text);
  void showRows(const ParameterRow* edited);
  void showMissing();
  void applyAccess();
  void chooseFile(ParameterRow& row);
  void showTexts();
  void applyStyle();

  Scene scene_;
  Scene passedOn_;  // the newest scene that was set or passed on
  KeptSizes sizes_;
  LineSize line_;  // of the present line, if it belongs to the scene
  FileChooser chooser_;
  std::map<std::string, RowAccess> access_;
  QSet<QString> complaints_;           // keys of showError()
  QMap<QString, ParameterRow*> rows_;  // by key
  /// Titles of groups: with a line of their own, or in the group's first row.
  std::vector<std::pair<QLabel*, std::function<QString()>>> headings_;
  QMap<const ParameterRow*, std::function<QString()>> headingRows_;
  QScrollArea* scroll_;
};

}  // namespace asperity
