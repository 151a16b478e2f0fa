// The page of the paper's figures: the list at the left, the picture at the right with the paper's
// sentences about it below, computed live in the background. It replaces the views in the main
// window, which owns it. GUI thread.
// Failure: messages appear in a bar over the page, which stays usable.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "ui/window/figures/figure_queue.h"

class QProgressBar;
class QPushButton;
class QSpinBox;

namespace asperity {

class ClaimsTable;
class DiagramView;
class ElidedLabel;
class FigureList;
class MessageBar;

class FiguresPage : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kQuick = 20;   // realizations; a result within seconds
  static constexpr int kPaper = 200;  // as many realizations as in the paper

  explicit FiguresPage(FigureMaker maker = makeFigure, QWidget* parent = nullptr);
  ~FiguresPage() override;

  FigureQueue& queue() { return *queue_; }
  DiagramView& picture() { return *picture_; }
  MessageBar& messages() { return *messages_; }

  /// Shows this figure; with `compute`, it is computed where it is missing.
  void choose(FigureName name, bool compute);
  FigureName chosen() const;

  /// Saves the chosen figure, as a print or as its table or claims, by the extension. The file is
  /// written in the background; a note or an error message follows.
  void savePicture(const QString& file);
  void saveData(const QString& file);
  void askPicture();
  /// Copies the picture as it is on the screen to the clipboard.
  void copyPicture();
  /// Returns whether the chosen figure has been computed.
  bool hasFigure() const { return shown_ != nullptr; }

 signals:
  /// Emitted when another figure, or none, is shown.
  void figureShown();
  void closed();
  void sceneRequested(const asperity::Scene& scene);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeHeading();
  QWidget* makeLeft();
  QWidget* makeRight();
  QWidget* makeChoices();
  QWidget* makeCommands();
  QPushButton* addButton(QLayout& row, const char* name, QString (*text)(), QString (*tip)(),
                         std::function<void()> run);

  void setStyle();
  void compute();
  void computeAll();
  void askData();
  void save(const QString& file,
            void (*write)(const std::filesystem::path&, const ComputedFigure&));
  void describePicture();
  void showChosen();
  void showComputed(std::shared_ptr<const ComputedFigure> made);
  void showWork();

  FigureQueue* queue_;
  std::shared_ptr<const ComputedFigure> shown_;  // null: a text is shown
  MessageBar* messages_ = nullptr;
  FigureList* list_ = nullptr;
  DiagramView* picture_ = nullptr;
  ClaimsTable* claims_ = nullptr;
  QSpinBox* realizations_ = nullptr;
  QProgressBar* progress_ = nullptr;
  ElidedLabel* note_ = nullptr;  // shown instead of the progress while nothing is computed
  QPushButton *compute_ = nullptr, *cancel_ = nullptr, *openScene_ = nullptr;
  QPushButton *savePicture_ = nullptr, *saveData_ = nullptr;
  BackgroundWork saving_{RequestPolicy::RunInOrder};  // last: its thread ends first
};

}  // namespace asperity
