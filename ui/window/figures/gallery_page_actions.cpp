// The commands of the page of figures: computing, playing with a figure's scene, saving.
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLabel>
#include <QSpinBox>
#include <exception>

#include "ui/language/translated.h"
#include "ui/window/figures/figure_files.h"
#include "ui/window/figures/figure_list.h"
#include "ui/window/figures/figure_picture.h"
#include "ui/window/figures/gallery_page.h"
#include "ui/window/main/ask_file.h"
#include "ui/window/main/message_bar.h"

namespace asperity {

void GalleryPage::choose(FigureName name, bool compute) {
  list_->choose(name);
  if (compute && !gallery_->status(name).made) this->compute();
}

void GalleryPage::chooseQuick() {
  realizations_->setValue(kQuick);
}

void GalleryPage::choosePaper() {
  realizations_->setValue(kPaper);
}

void GalleryPage::compute() {
  note_->clear();
  gallery_->compute(chosen(), realizations_->value());
}

/// Those that are not there with as many lines.
void GalleryPage::computeAll() {
  note_->clear();
  for (const FigureEntry& entry : figureEntries()) {
    const std::shared_ptr<const MadeFigure> made = gallery_->status(entry.name).made;
    if (!made || made->realizations != realizations_->value())
      gallery_->compute(entry.name, realizations_->value());
  }
}

void GalleryPage::openScene() {
  emit sceneWanted(gallery_->status(chosen()).made->figure.scene);
}

void GalleryPage::askPicture() {
  const QString file = askSaveFile(this, tr("Save picture"), figureFile(chosen(), ".png"),
                                   tr("Pictures (*.png *.svg *.pdf)"));
  if (!file.isEmpty()) savePicture(file);
}

void GalleryPage::askData() {
  const QString file = askSaveFile(this, tr("Save data"), figureFile(chosen(), ".csv"),
                                   tr("Table (*.csv);;Claims (*.json)"));
  if (!file.isEmpty()) saveData(file);
}

void GalleryPage::copyPicture() {
  if (!picture_->isPainted()) return;
  QGuiApplication::clipboard()->setImage(picture_->image());
  note_->setText(tr("The picture is on the clipboard"));
}

void GalleryPage::savePicture(const QString& file) {
  save(file, writeFigurePicture);
}

void GalleryPage::saveData(const QString& file) {
  save(file, writeFigureData);
}

void GalleryPage::save(const QString& file,
                       void (*write)(const std::filesystem::path&, const MadeFigure&)) {
  const std::shared_ptr<const MadeFigure> made = gallery_->status(chosen()).made;
  if (!made) return;
  note_->setText(tr("Saving %1…").arg(QFileInfo(file).fileName()));
  saving_ = std::jthread([this, file, made, write] {
    QString complaint;
    try {
      write(file.toStdString(), *made);
    } catch (const std::exception& error) {
      complaint = translatedError(error);
    }
    QMetaObject::invokeMethod(this, [this, file, complaint] {
      if (complaint.isEmpty()) {
        note_->setText(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
        if (messages_->end(MessageBar::Failure::Export)) showChosen();
        emit saved(file);
      } else {
        note_->clear();
        messages_->showFailure(MessageBar::Failure::Export, complaint);
      }
    });
  });
}

}  // namespace asperity
