#include "ui/window/figures/diagram_files.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <filesystem>
#include <utility>

#include "core/base/atomic_file.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/picture_file.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/file_dialogs.h"

namespace asperity {

DiagramFiles::DiagramFiles(QWidget& view)
    : QObject(&view),
      view_(view),
      copy_(named<QAction>("copyDiagram", this)),
      save_(named<QAction>("saveDiagram", this)) {
  connect(copy_, &QAction::triggered, this, &DiagramFiles::copy);
  connect(save_, &QAction::triggered, this, &DiagramFiles::saveAs);
  setDiagram({});
  keepTranslated(*this, [this] { showTexts(); });
}

void DiagramFiles::setDiagram(DiagramExport diagram) {
  diagram_ = std::move(diagram);
  for (QAction* action : actions()) action->setEnabled(!isEmpty());
  showTexts();
}

/// Returns what is saved, for the menu and the title of the dialog behind it.
QString DiagramFiles::saveText() const {
  return diagram_.table ? tr("Save picture or data") : tr("Save picture");
}

void DiagramFiles::showTexts() {
  copy_->setText(tr("Copy picture"));
  save_->setText(saveText() + QStringLiteral("…"));
}

void DiagramFiles::saveAs() {
  QString filters = pictureFilter();
  if (diagram_.table) filters += ";;" + tr("Tables (*.csv)");
  const QString file = askSaveFile(&view_, saveText(), diagram_.name + ".png", filters);
  if (!file.isEmpty()) save(file);
}

void DiagramFiles::save(const QString& file) {
  work_.request(
      [diagram = diagram_, theme = pictureTheme(view_.palette()),
       file](const BackgroundWork::Run&) {
        const std::filesystem::path path = file.toStdString();
        if (diagram.table && file.endsWith(".csv", Qt::CaseInsensitive))
          return writeFileAtomically(path, diagram.table());
        const DiagramSheet sheet = diagram.sheet();
        const DiagramOptions options = printOptions(sheet, theme);
        writePicture(path, composeDiagrams(sheet, options),
                     {translated(sheet.title), diagram.origin ? diagram.origin() : std::string(),
                      options.scale});
      },
      [this, file] { emit saved(file); }, [this](const LiveText& reason) { emit failed(reason); });
}

void DiagramFiles::copy() {
  work_.request(
      [make = diagram_.sheet, theme = pictureTheme(view_.palette())](const BackgroundWork::Run&) {
        const DiagramSheet sheet = make();
        return renderImage(contextOfThread(), composeDiagrams(sheet, printOptions(sheet, theme)));
      },
      [this](const QImage& image) {
        QGuiApplication::clipboard()->setImage(image);
        emit copied();
      },
      [this](const LiveText& reason) { emit failed(reason); });
}

}  // namespace asperity
