#include "ui/window/lesson/handout.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFontMetricsF>
#include <QHashFunctions>
#include <QMessageBox>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QPushButton>
#include <QStringList>
#include <QTextBlock>
#include <QTextDocument>
#include <memory>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "ui/draw/fonts.h"
#include "ui/draw/picture_file.h"
#include "ui/language/language.h"
#include "ui/window/lesson/lesson_text.h"
#include "ui/window/main/file_dialogs.h"

namespace asperity {

namespace {

// On paper, in millimetres.
constexpr double kMargin = 22, kShownWidth = 166, kGap = 2.5, kTextGap = 1.3, kHeadingGap = 4,
                 kFootHeight = 8;
constexpr double kShort = 0.72;       // part of a page; what is shorter stays together
constexpr double kLessHeight = 0.15;  // part of a picture by which it may be smaller to fit
constexpr int kResolution = 300;      // per inch
constexpr double kRounding = 0.01;    // dots

constexpr const char* kStyle =
    "body{font-family:'DejaVu Sans',sans-serif;line-height:1.45;color:#222;max-width:46em;"
    "margin:2em auto;padding:0 1em}h1{font-size:1.6em}h2{font-size:1.15em;margin-top:1.8em}"
    "img{max-width:100%;border:1px solid #ddd}"
    ".page{border-top:1px solid #ddd;margin-top:3em;break-before:page}"
    "@media print{h1,h2,.stays{break-after:avoid}p,img,.question{break-inside:avoid}"
    "body{margin:0}}";

/// The pages on paper. What stays together goes to the next page as a whole, unless it is larger
/// than one or fits with slightly smaller pictures; a text that is larger than a page goes on over
/// the next pages.
class HandoutPages {
 public:
  HandoutPages(QPdfWriter& writer, const QString& title, const std::vector<HandoutBlock>& blocks)
      : writer_(writer),
        title_(title),
        blocks_(blocks),
        painter_(&writer),
        available_(writer.height() - dots(kFootHeight)) {
    for (const HandoutBlock& block : blocks_) parts_.push_back(layOut(block));
  }

  void draw() {
    const std::vector<Page> pages = makePages();
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (i > 0) writer_.newPage();
      double y = 0;
      for (const auto& [part, from] : pages[i]) {
        y += y == 0 ? 0 : parts_[part].above;
        drawPart(part, from, y);
        y += parts_[part].height - from;
      }
      drawFoot(QStringLiteral("%1 / %2").arg(i + 1).arg(pages.size()));
    }
  }

 private:
  struct Part {
    std::unique_ptr<QTextDocument> text;  // none: a picture
    double above = 0;                     // dots, of the gap below what is above it on the page
    double height = 0;                    // dots, with the gap below
  };
  /// A part on a page, or what is left of it from a height on.
  struct Placed {
    std::size_t part;
    double from;  // dots
  };
  using Page = std::vector<Placed>;

  static double dots(double millimetres) { return millimetres / 25.4 * kResolution; }

  Part layOut(const HandoutBlock& block) const {
    Part part;
    if (block.picture) {
      const QSize size = block.picture->image.size();
      part.height = dots(kShownWidth) * size.height() / size.width() + dots(kGap);
      return part;
    }
    part.text = std::make_unique<QTextDocument>();
    part.text->setDocumentMargin(0);
    part.text->documentLayout()->setPaintDevice(painter_.device());
    part.text->setDefaultFont(QFont(QStringLiteral("DejaVu Sans"), 10));
    part.text->setDefaultStyleSheet(
        QStringLiteral("h1{font-size:18pt;margin:0 0 8px 0} h2{font-size:13pt;margin:12px 0 4px 0} "
                       "h3{font-size:10pt;font-weight:normal;color:#555;margin:0 0 8px 0} "
                       "p{margin:0 0 6px 0} ul{margin:0 0 6px 0} li{margin:0 0 3px 0}"));
    part.text->setHtml(block.html);
    part.text->setTextWidth(writer_.width());
    part.above = block.html.startsWith("<h2") ? dots(kHeadingGap) : 0;
    double height = part.text->size().height();
    if (height > available_) {  // its pages end between two lines
      part.text->setPageSize(QSizeF(writer_.width(), available_));
      height = part.text->documentLayout()->blockBoundingRect(part.text->lastBlock()).bottom();
    }
    part.height = height + dots(kTextGap);
    return part;
  }

  /// Returns the end of the parts that stay together in any case, as far as a page has room.
  std::size_t groupEnd(std::size_t first) const {
    std::size_t end = first + 1;
    while (end < parts_.size() && blocks_[end - 1].withNext == KeepWithNext::Always &&
           groupHeight(first, end + 1) <= available_)
      ++end;
    return end;
  }

  double groupHeight(std::size_t first, std::size_t end) const {
    double height = 0;
    for (std::size_t i = first; i < end; ++i) height += parts_[i].above + parts_[i].height;
    return height;
  }

  /// Makes the pictures of a group smaller where it then fits on a page on which it lacks some
  /// height, and returns the height of the group.
  double fitPictures(std::size_t first, std::size_t end, double lacking) {
    double pictures = 0;
    for (std::size_t i = first; i < end; ++i)
      if (blocks_[i].picture) pictures += parts_[i].height;
    if (lacking > 0 && lacking <= kLessHeight * pictures)
      for (std::size_t i = first; i < end; ++i)
        if (blocks_[i].picture) parts_[i].height *= 1 - lacking / pictures;
    return groupHeight(first, end);
  }

  std::vector<Page> makePages() {
    std::vector<Page> pages(1);
    double used = 0;
    for (std::size_t first = 0; first < parts_.size();) {
      std::size_t end = groupEnd(first);
      while (end < parts_.size() && blocks_[end - 1].withNext == KeepWithNext::IfShort &&
             groupHeight(first, groupEnd(end)) <= kShort * available_)
        end = groupEnd(end);
      double height = groupHeight(first, end);
      if (!blocks_[first].beginsPage)
        height = fitPictures(first, end, used + height + kRounding - available_);
      if (used > 0 && (blocks_[first].beginsPage || used + height > available_)) {
        pages.emplace_back();
        used = 0;
      }
      used += height;
      for (; first < end; ++first) pages.back().push_back({first, 0});
      // Only a text alone is larger than a page.
      for (double from = available_; used > available_ + dots(kTextGap); from += available_) {
        pages.push_back({{end - 1, from}});
        used -= available_;
      }
    }
    return pages;
  }

  void drawPart(std::size_t place, double from, double y) {
    if (const HandoutBlock& block = blocks_[place]; block.picture) {
      const QSizeF image = block.picture->image.size();
      const double height = parts_[place].height - dots(kGap);
      const QSizeF size(height * image.width() / image.height(), height);
      painter_.drawImage(QRectF(QPointF(0, y), size), block.picture->image);
      return;
    }
    painter_.save();
    painter_.translate(0, y - from);
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, Qt::black);  // also where the window is dark
    if (parts_[place].text->pageCount() > 1) {
      context.clip = QRectF(0, from, writer_.width(), available_);
      painter_.setClipRect(context.clip);
    }
    parts_[place].text->documentLayout()->draw(&painter_, context);
    painter_.restore();
  }

  void drawFoot(const QString& page) {
    painter_.setFont(QFont(QStringLiteral("DejaVu Sans"), 8));
    painter_.setPen(Qt::darkGray);
    const QRectF foot(0, writer_.height() - dots(kFootHeight), writer_.width(), dots(kFootHeight));
    const QFontMetricsF metrics(painter_.font(), &writer_);
    const double room = foot.width() - metrics.horizontalAdvance(page + QStringLiteral("  "));
    painter_.drawText(foot, Qt::AlignBottom | Qt::AlignLeft,
                      metrics.elidedText(title_, Qt::ElideRight, room));
    painter_.drawText(foot, Qt::AlignBottom | Qt::AlignRight, page);
  }

  QPdfWriter& writer_;
  const QString& title_;
  const std::vector<HandoutBlock>& blocks_;
  QPainter painter_;
  const double available_;  // dots, of the height of a page above its foot
  std::vector<Part> parts_;
};

QByteArray pngBytes(const QImage& image) {
  const std::string bytes = encodePng(image);
  return {bytes.data(), static_cast<qsizetype>(bytes.size())};
}

}  // namespace

QByteArray handoutHtml(const Lesson& lesson, const HandoutOptions& options) {
  loadFonts();
  QByteArray html = "<!DOCTYPE html>\n<html lang=\"";
  html += presentLanguage() == "de" ? "de" : "en";
  html += "\">\n<head><meta charset=\"utf-8\"><title>" +
          plainText(lesson.title).toHtmlEscaped().toUtf8() +
          "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n<style>" + kStyle +
          "</style></head>\n<body>\n";
  for (const HandoutBlock& block : handoutBlocks(lesson, options)) {
    QStringList classes;
    if (block.withNext != KeepWithNext::No) classes += "stays";
    if (block.beginsPage) classes += "page";
    if (block.isQuestion) classes += "question";
    if (!classes.isEmpty()) html += "<div class=\"" + classes.join(' ').toLatin1() + "\">";
    html += block.html.toUtf8();
    if (block.picture)
      html += "<p><img alt=\"" + block.picture->name.toHtmlEscaped().toUtf8() +
              "\" src=\"data:image/png;base64," + pngBytes(block.picture->image).toBase64() +
              "\"></p>";
    html += classes.isEmpty() ? "\n" : "</div>\n";
  }
  return html + "</body>\n</html>\n";
}

QByteArray handoutPdf(const Lesson& lesson, const HandoutOptions& options) {
  loadFonts();
  QHashSeed::setDeterministicGlobalSeed();  // it determines the order of fonts in the file
  const std::vector<HandoutBlock> blocks = handoutBlocks(lesson, options);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({kMargin, kMargin, kMargin, kMargin - kFootHeight},
                          QPageLayout::Millimeter);
    const QString title = plainText(lesson.title);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Asperity " ASPERITY_VERSION));
    HandoutPages(writer, title, blocks).draw();
  }
  blankDate(bytes);
  return bytes;
}

void writeHandout(const std::filesystem::path& file, const Lesson& lesson,
                  const HandoutOptions& options) {
  const std::string extension = file.extension().string();
  if (extension != ".html" && extension != ".pdf")
    throw unknownExtension(file.string(), extension, {".html", ".pdf"});
  checkWritable(file);
  const QByteArray bytes =
      extension == ".pdf" ? handoutPdf(lesson, options) : handoutHtml(lesson, options);
  writeFileAtomically(file, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

// ---- Saving in the window

HandoutSaver::HandoutSaver(QWidget* page)
    : QObject(page->parentWidget() ? page->parentWidget() : page), page_(page) {
  connect(page, &QObject::destroyed, this, [this] {
    if (!isSaving()) deleteLater();
  });
}

void HandoutSaver::ask(const Lesson& lesson, const QString& name) {
  QMessageBox box(QMessageBox::Question, tr("Handout"),
                  tr("A handout for students has the questions; one for teachers has the answers "
                     "and the notes, too."),
                  QMessageBox::Cancel, page_);
  box.setObjectName("handoutQuestion");
  auto* students = box.addButton(tr("For &students"), QMessageBox::AcceptRole);
  auto* teachers = box.addButton(tr("For &teachers"), QMessageBox::AcceptRole);
  box.button(QMessageBox::Cancel)->setText(tr("&Cancel"));
  box.setDefaultButton(students);
  box.exec();
  if (box.clickedButton() != students && box.clickedButton() != teachers) return;
  const bool forTeacher = box.clickedButton() == teachers;
  const QString proposed = name + (forTeacher ? "_teacher.pdf" : ".pdf");
  const QString file =
      askSaveFile(page_, tr("Save handout"), proposed, tr("PDF (*.pdf);;Web page (*.html)"));
  if (!file.isEmpty()) save(lesson, file, forTeacher);
}

void HandoutSaver::save(const Lesson& lesson, const QString& file, bool forTeacher) {
  if (isSaving()) return;
  work_.request(
      [lesson, file, forTeacher](const BackgroundWork::Run& run) {
        HandoutOptions options;
        options.forTeacher = forTeacher;
        options.stop = run.stop();
        writeHandout(file.toStdString(), lesson, options);
      },
      [this, file] { showStatus([file] { return savedText(file); }); },
      [this](const LiveText& reason) { showStatus(reason); });
  showStatus([] { return tr("The program draws the pictures and computes the answers…"); });
}

void HandoutSaver::showStatus(const LiveText& status) {
  emit statusChanged(status);
  if (page_ || isSaving()) return;
  emit endedWithoutPage(status);
  deleteLater();
}

}  // namespace asperity
