// The panel of parameters, generated from the table alone: one ParameterRow for each row, grouped
// by section, in a scroll area. Owns the scene that its controls show; every accepted change is a
// new scene. A refused text changes nothing and is explained where it was typed; a scene that still
// misses something is kept and says so, but is not passed on. GUI thread.
#pragma once

#include <QMap>
#include <QSet>
#include <QWidget>
#include <functional>
#include <optional>

#include "core/scene/scene.h"
#include "ui/panels/profile_defaults.h"
#include "ui/panels/value_entry.h"

class QScrollArea;
class QVBoxLayout;

namespace asperity {

class ParameterRow;
struct Parameter;

/// Asks a person for a file, beginning in a folder; empty where none was chosen.
using FileChooser = std::function<QString(QWidget* parent, const QString& folder)>;

/// What a panel shows beyond its scene.
struct PanelState {
  QMap<QString, TypedText> typed;  // by the entry's name
  std::optional<bool> armsOpened;
  int scrolled = 0;
};

class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterPanel(const Scene& scene, QWidget* parent = nullptr);

  const Scene& scene() const { return scene_; }

  /// Shows another scene; emits nothing.
  void setScene(const Scene& scene);

  /// For a panel of the same scene in this one's place.
  PanelState state() const;
  void setState(const PanelState& state);

  /// A complaint about a parameter that only came up when the scene ran. Unknown keys are ignored.
  void showError(const QString& key, const QString& text);

  /// The scene runs: takes such complaints away.
  void clearErrors();

  /// The line that is on the screen, for what the scene leaves to a file.
  void showLine(const LineSize& line);

  /// A file dialog unless told otherwise.
  void setFileChooser(FileChooser chooser);

  QSize sizeHint() const override;

 signals:
  void sceneEdited(const asperity::Scene& scene);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addSection(QVBoxLayout& column, const QString& section);
  void addRow(QVBoxLayout& column, const Parameter& parameter, const QString& heading);
  template <class Change>
  void edit(ParameterRow& row, Change&& change, const QString& refusal = {});
  void takeText(ParameterRow& row, const QString& text);
  void showRows(const ParameterRow* edited);
  void showMissing();
  void chooseFile(ParameterRow& row);
  void applyStyle();

  Scene scene_;
  Scene passedOn_;  // the newest that came from outside or went there
  KeptSizes sizes_;
  LineSize line_;  // on the screen, where it is the scene's
  FileChooser chooser_;
  QSet<QString> complaints_;           // keys of showError()
  QMap<QString, ParameterRow*> rows_;  // by key
  QScrollArea* scroll_;
};

}  // namespace asperity
