// The panel of parameters, generated from the table: the rows that the scene needs, in sections
// that fold, in a scroll area, below a bar that chooses between the essential rows and all and
// filters them. It owns the scene that its controls show; every accepted change makes a new scene.
// A refused text changes nothing, and the reason is shown where it was typed; an incomplete scene
// is kept with a note, but not passed on. Remarks come and go below rows: while a slider is held
// they wait, and otherwise the row that the user works with keeps its place on the screen. GUI
// thread.
#pragma once

#include <QMap>
#include <QStringList>
#include <QWidget>
#include <map>
#include <string>
#include <vector>

#include "core/scene/notes.h"
#include "core/scene/scene.h"
#include "ui/panels/controls.h"
#include "ui/panels/profile_defaults.h"
#include "ui/panels/row_list.h"
#include "ui/panels/value_entry.h"

class QScrollArea;
class QTimer;

namespace asperity {

class PanelBar;
class ParameterRow;

/// The state of the panel that is kept from one start to the next.
struct PanelView {
  bool showsAll = false;
  QStringList folded;  // names of groups

  bool operator==(const PanelView&) const = default;
};

/// A scene that the panel is going to show, and what the user may then do with its rows.
struct PlannedRows {
  Scene scene;
  std::map<std::string, RowAccess> access;
};

class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  /// Makes a panel of all rows of the table, by section.
  explicit ParameterPanel(const Scene& scene, QWidget* parent = nullptr);
  /// Makes a panel of some rows of the table, all of them visible, without the bar.
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

  /// Sets what a user may do with rows: by key ("load.normal_force"), by section ("load") or for
  /// all others ("*"). The longest name counts; rows without one are free. A row that is named as
  /// free or locked is visible among the essential ones, too. An empty map frees everything.
  void setRowAccess(const std::map<std::string, RowAccess>& access);

  /// Makes the panel as wide as all these scenes need, such as those of a lesson, so that it keeps
  /// its width from one to the next. An empty list ends this.
  void planRows(const std::vector<PlannedRows>& plan);

  /// Shows each note as a warning at the row it is about, until the next call.
  void showNotes(const NoteSet& notes);

  /// Shows a row, even if it is folded or filtered out, and gives it the focus. Unknown keys are
  /// ignored.
  void reveal(const QString& key);

  /// Puts the cursor into the filter.
  void focusFilter();

  /// Removes the filter, which would hide most rows of another scene.
  void clearFilter();

  PanelView view() const;
  void setView(const PanelView& view);
  /// Returns the view of the first start.
  static PanelView defaultView();

  /// Replaces the usual file dialog.
  void setFileChooser(FileChooser chooser);

  QSize sizeHint() const override;

 signals:
  void sceneEdited(const asperity::Scene& scene);
  /// Emitted when the user requests to open a measured surface, or a material, for this scene.
  void surfaceRequested(const asperity::Scene& scene);
  void materialRequested(const asperity::Scene& scene);
  /// Emitted when the user requests to add a table of measured friction.
  void frictionRequested();
  /// Emitted when the user requests the guide about a parameter, at this anchor.
  void guideRequested(const QString& anchor);
  /// Emitted when Escape leaves the filter.
  void filterLeft();
  /// Emitted when the scene no longer has the rows that forced the panel to be wider than the user
  /// chose, with the width that is now enough.
  void widthReleased(int width);

 protected:
  void changeEvent(QEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  ParameterPanel(const Scene& scene, const std::vector<ParameterGroup>& groups, PanelBar* bar,
                 QWidget* parent);
  void takeRow(ParameterRow* row);
  template <class Change>
  void edit(ParameterRow& row, Change&& change, const QString& refusal = {});
  void takeText(ParameterRow& row, const QString& text);
  void showRows(const ParameterRow* edited);
  template <class Change>
  void keepInPlace(Change&& change);
  void showOtherRows();
  void arrange();
  bool isHeld() const;
  void updateRemarks();
  void showRemarks(bool withWarnings = true);
  void showWaitingRemarks();
  ParameterRow* rowInUse() const;
  void measurePlan();
  void updateWidth();
  bool showsAll() const;
  void showMissing();
  void chooseFile(ParameterRow& row);
  void showTexts();
  void applyStyle();

  Scene scene_;
  Scene passedOn_;  // the newest scene that was set or passed on
  RememberedSizes sizes_;
  LineSize line_;  // of the present line, if it belongs to the scene
  FileChooser chooser_;
  QMap<QString, QString> runErrors_;   // texts of showError(), by key
  int chosenWidth_ = QWIDGETSIZE_MAX;  // by the user; rows may need more
  std::vector<PlannedRows> plan_;
  int plannedWidth_ = 0;            // pixels that its rows need
  bool areRemarksWaiting_ = false;  // until the rows may move
  QTimer* remarkDelay_;             // from the last change of a waiting warning
  NoteSet notes_;
  QString revealed_;  // key of a row that reveal() made visible, until other rows are chosen
  PanelBar* bar_;     // may be null
  QScrollArea* scroll_;
  RowList* rows_;
};

}  // namespace asperity
