// The page of the shipped scenes: a filter, and below it a card with a picture for each scene, by
// chapter. It is the first page of a first start. It replaces the views in the main window, which
// owns it. GUI thread. Failure: a scene whose picture cannot be drawn has none.
#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;

namespace asperity {

class CardList;
class SceneThumbnails;
class TitleBar;

class SceneGallery : public QWidget {
  Q_OBJECT

 public:
  explicit SceneGallery(QWidget* parent = nullptr);

  /// Makes the card of this scene the current one; an unknown name leaves it.
  void choose(const QString& scene);
  void focusFilter();
  /// Adds a button for a command to the heading, for example for the lessons. Call it when the
  /// gallery has its window: before that, Qt does not change the order of the Tab key.
  void addCommand(QAction& command);

  CardList& cards() { return *cards_; }
  SceneThumbnails& thumbnails() { return *thumbnails_; }

 signals:
  /// Emitted with the name of a shipped scene that the user chose.
  void chosen(const QString& scene);
  void closed();

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fillHeading();
  void showCards();
  void showTexts();
  void leave();

  SceneThumbnails* thumbnails_;
  TitleBar* heading_;
  QLabel* none_ = nullptr;
  QLineEdit* filter_ = nullptr;
  CardList* cards_ = nullptr;
};

}  // namespace asperity
