// The commands of the friction diagram: pins, axes, view, files. Each is an action with a name and,
// where it has one, a key. GUI thread; belongs to its parent. Failure: the exporter reports it.
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "core/chart/curve_set.h"

class QAction;
class QMenu;

namespace asperity {

class ChartView;
class Session;

class CurveCommands : public QObject {
  Q_OBJECT

 public:
  /// Runs `work` in the background, then `done` on the GUI thread, or shows the error.
  using Export = std::function<void(std::function<void()> work, std::function<void()> done)>;

  CurveCommands(Session& session, ChartView& view, Export run, QObject* parent);

  /// Adds all commands to the menu, and most of them to the view's context menu; call it once.
  void fill(QMenu& menu);

  /// Returns the curves as they are shown; nothing before the first.
  std::optional<CurveSet> shown() const;

  /// Saves PNG, SVG, PDF or CSV, by the extension.
  void save(const QString& file);

 signals:
  /// Emitted with the file, or an empty text for the clipboard.
  void exported(const QString& file);

 private:
  QAction* add(const char* name, std::function<void()> run);
  void showTexts();
  void fillUnpin();
  void showState();
  void askSave();
  void copyPicture();
  void setAxes(bool dimensionless);

  Session& session_;
  ChartView& view_;
  Export run_;
  QAction *pin_, *unpinAll_, *dimensionless_, *nearer_, *farther_, *fit_, *save_, *copy_;
  QMenu* unpin_ = nullptr;
};

}  // namespace asperity
