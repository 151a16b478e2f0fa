// The files of a diagram: its picture, and its numbers where it has a table. They are written in
// the background, one after the other, and so is the picture for the clipboard. GUI thread; owned
// by the widget that shows the diagram. Failure: the signal failed() has the reason.
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <string>

#include "core/chart/diagram.h"
#include "ui/language/language.h"
#include "ui/window/tasks/background_work.h"

class QAction;
class QWidget;

namespace asperity {

/// Makes a diagram. It is called on the worker's thread and may throw.
using DiagramMaker = std::function<DiagramSheet()>;

/// What is saved of a diagram. All functions are called on the worker's thread.
struct DiagramExport {
  QString name{};                         // proposed: "material"; empty: it cannot be saved
  std::function<std::string()> origin{};  // provenance of the picture; may be empty
  std::function<std::string()> table{};   // its numbers as CSV; may be empty
  DiagramMaker sheet{};                   // in a DiagramView, empty: the sheet that it shows
};

class DiagramFiles : public QObject {
  Q_OBJECT

 public:
  /// view: the widget that shows the diagram; pictures have the colours of its palette.
  explicit DiagramFiles(QWidget& view);

  /// Sets the diagram that is saved from now on.
  void setDiagram(DiagramExport diagram);

  /// Returns the actions that copy and save the picture, for a context menu. They are disabled
  /// while there is no diagram.
  QList<QAction*> actions() const { return {copy_, save_}; }
  bool isEmpty() const { return diagram_.name.isEmpty(); }

  /// Opens a file dialog and writes the diagram to the chosen file.
  void saveAs();
  /// Writes .png, .svg, .pdf, or .csv where the diagram has a table. saved() or failed() follows.
  void save(const QString& file);
  /// Puts the picture on the clipboard; copied() or failed() follows.
  void copy();

 signals:
  void failed(const asperity::LiveText& reason);
  void saved(const QString& file);
  void copied();

 private:
  QString saveText() const;
  void showTexts();

  QWidget& view_;
  DiagramExport diagram_;
  QAction *copy_, *save_;
  BackgroundWork work_{RequestPolicy::RunInOrder};  // last: its thread ends first
};

}  // namespace asperity
