#include "ui/window/lesson/handout.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QHashFunctions>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QStringList>
#include <QTextDocument>
#include <memory>
#include <optional>
#include <vector>

#include "core/accuracy/compute_curve.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/chart/curve_diagram.h"
#include "core/chart/curve_set.h"
#include "core/chart/curve_words.h"
#include "core/chart/material_sheets.h"
#include "core/friction/curve_quantity.h"
#include "core/lesson/lesson_answers.h"
#include "core/run/line_diagrams.h"
#include "core/run/simulation.h"
#include "core/run/steady_frames.h"
#include "core/scene/sweep.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pdf_file.h"
#include "ui/draw/pixel_context.h"
#include "ui/draw/png_file.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {

namespace {

constexpr int kContactWidth = 1500, kContactHeight = 420, kChartWidth = 1300, kChartHeight = 600;
constexpr float kPictureScale = 2;
// On paper, in millimetres.
constexpr double kMargin = 22, kShownWidth = 150, kGap = 2.5, kTextGap = 1.3, kHeadingGap = 4,
                 kFootHeight = 8;
constexpr double kShort = 0.72;   // part of a page; what is shorter stays together
constexpr int kResolution = 300;  // per inch

struct Picture {
  QImage image;
  QString name;  // the alternative text of the picture
};

/// Whether a block stays on the page of the next one: a heading stays with its text; the pictures
/// above a question stay with it where that leaves no large part of a page empty.
enum class KeepWithNext { No, IfShort, Always };

/// A block of the page: HTML, or a picture. On paper it is never split.
struct Block {
  QString html;
  std::optional<Picture> picture{};
  KeepWithNext withNext = KeepWithNext::No;
  bool beginsPage = false;
};

Scene untitled(Scene scene) {
  scene.title.clear();
  scene.description.clear();
  return scene;
}

bool haveSameContact(const Scene& a, const Scene& b) {
  return a.surface == b.surface && a.elastomer == b.elastomer && a.load == b.load &&
         a.sliding == b.sliding;
}

class HandoutMaker {
 public:
  HandoutMaker(const Lesson& lesson, const HandoutOptions& options)
      : lesson_(withWholeQuestions(lesson)), options_(options) {}

  std::vector<Block> make() {
    addHead();
    for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
      throwIfStopped(options_.stop);
      addStep(static_cast<int>(i));
      if (options_.progress)
        options_.progress(static_cast<double>(i + 1) / static_cast<double>(lesson_.steps.size()));
    }
    return std::move(blocks_);
  }

 private:
  void add(const QString& html, KeepWithNext withNext = KeepWithNext::No) {
    blocks_.push_back({html, {}, withNext});
  }

  void addHead() {
    add("<h1>" + plainText(lesson_.title).toHtmlEscaped() + "</h1>", KeepWithNext::Always);
    add("<p><b>" + fromUtf8(Words::tr("Goal")) + ":</b> " +
        plainText(lesson_.goal).toHtmlEscaped() + " (" +
        fromUtf8(Words::tr("%1 minutes")).arg(lesson_.minutes) + ")</p>");
    if (!options_.forTeacher)
      add("<p>" + fromUtf8(Words::tr("Name")) + ": ______________________________</p>");
    if (!options_.forTeacher || lesson_.notes.empty()) return;
    add("<h2>" + fromUtf8(Words::tr("Notes for the teacher")) + "</h2>", KeepWithNext::Always);
    add(richText(shown(lesson_.notes)));
  }

  void addStep(int number) {
    const LessonStep& step = lesson_.steps[static_cast<std::size_t>(number)];
    const bool tells = number > 0 && !options_.forTeacher && mayTellAnswer(number);
    if (tells) {
      blocks_.back().withNext = KeepWithNext::Always;
      add("<p><i>" + fromUtf8(Words::tr("Turn the page when you have answered.")) + "</i></p>");
    }
    add(QStringLiteral("<h2>%1. %2</h2>")
            .arg(number + 1)
            .arg(plainText(step.title).toHtmlEscaped()),
        KeepWithNext::Always);
    blocks_.back().beginsPage = tells;
    add(richText(shown(step.text)));
    const std::size_t text = blocks_.size() - 1;
    addContact(step.scene);
    if (isDrawnInto(step) || !step.show.hidesCurve) addChart(step, step.scene, isDrawnInto(step));
    keepTogether(text);
    if (!step.prediction) return;
    // Students draw their answer to the question below into an empty chart.
    blocks_.back().withNext = isDrawnInto(step) ? KeepWithNext::Always : KeepWithNext::IfShort;
    addQuestion(*step.prediction);
    if (options_.forTeacher) return addAnswer(step, number);
    // The revealed scene is visible on the screen only; in print it would reveal the answer.
    revealedContact_ = untitled(step.revealedScene);
    if (!step.show.hidesCurve) return;
    revealedCurve_ = canonicalCurveScene(step.revealedScene);
    revealedQuantity_ = step.show.quantity;
  }

  /// Returns whether a step may tell the answer to the question of the step before: on the screen
  /// that answer changed the picture or showed the curve, or the step shows another contact, or it
  /// asks nothing but explains.
  bool mayTellAnswer(int number) const {
    const LessonStep& step = lesson_.steps[static_cast<std::size_t>(number)];
    const LessonStep& before = lesson_.steps[static_cast<std::size_t>(number) - 1];
    if (!before.prediction) return false;
    const bool showsCurve = before.show.hidesCurve && !before.show.hidesCurveAfter;
    return !before.after.empty() || showsCurve || !haveSameContact(step.scene, before.scene) ||
           !step.prediction;
  }

  /// Returns whether the students draw their answer into an empty chart.
  static bool isDrawnInto(const LessonStep& step) {
    return step.prediction && step.prediction->kind == PredictionKind::Point;
  }

  static Frame makeFrame(const Scene& scene) {
    const auto shared = std::make_shared<const Scene>(scene);
    return scene.sliding.kind == SlidingKind::Steady ? SteadyFrames(shared).frameAt(0, 0, 0)
                                                     : Simulation(shared, 1).frame();
  }

  /// Adds the picture of a contact where it differs from the one before.
  void addContact(const Scene& given) {
    const Scene scene = untitled(given);
    const auto isShown = [&scene](const std::optional<Scene>& other) {
      return other && haveSameContact(*other, scene);
    };
    if (isShown(contact_) || isShown(revealedContact_)) return;
    contact_ = scene;
    ContactPictureOptions options;
    options.width = kContactWidth;
    options.height = kContactHeight;
    options.scale = kPictureScale;
    options.theme = printTheme();
    addPicture(composeContact(makeFrame(scene), options),
               fromUtf8(Words::tr("the contact of the rough line and the rubber")));
  }

  /// Adds what the step has in front where it differs from the chart before, or an empty chart that
  /// is drawn into. The other tabs show run times or need a pointer: they are not printed.
  void addChart(const LessonStep& step, const Scene& scene, bool isHidden) {
    if (step.show.tab == "curve")
      addCurve(step, scene, isHidden);
    else if (step.show.tab == "spectrum" && isNewChart(step, scene))
      addSheet(spectrumSheet(scene), fromUtf8(Words::tr("the spectrum of the line")));
    else if (step.show.tab == "statistics" && isNewChart(step, scene))
      addSheet(statisticsSheet(makeFrame(scene)),
               fromUtf8(Words::tr("the statistics of the line")));
    else if (step.show.tab == "material" && isNewChart(step, scene))
      addSheet(excitationSheet(scene), fromUtf8(Words::tr("the moduli of the elastomer")));
  }

  /// Returns whether the chart differs from the one before, and notes it as the last one.
  bool isNewChart(const LessonStep& step, const Scene& scene) {
    const auto plottedScene = [&](const Scene& of) {
      return step.show.tab == "curve" ? canonicalCurveScene(of) : untitled(of);
    };
    const std::string key =
        step.show.tab + " " + step.show.quantity + (step.show.isLinearY ? " linear" : "");
    const bool isNew =
        !chart_ || key != chartKey_ || !(plottedScene(*chart_) == plottedScene(scene));
    chart_ = scene;
    chartKey_ = key;
    return isNew;
  }

  void addCurve(const LessonStep& step, const Scene& scene, bool isHidden) {
    const bool isNew = isNewChart(step, scene);
    if (isHidden) chartKey_.clear();  // the whole curve is another chart
    if (!isNew && !isHidden && step.show.beside.empty()) return;
    const bool isAnswer = revealedCurve_ && *revealedCurve_ == canonicalCurveScene(scene) &&
                          revealedQuantity_ == step.show.quantity;
    if (isAnswer && !isHidden) return;
    CurveSet set;
    set.present = {{}, untitled(scene), computePoints(scene)};
    set.y = *findQuantity(step.show.quantity);
    if (step.show.isLinearY) set.yScale = AxisScale::Linear;
    for (std::size_t i = 0; i < step.show.beside.size(); ++i) {
      const Scene other = untitled(withKeys(step.scene, step.show.beside[i]));
      set.pinned.push_back({describeDifferences(other, untitled(step.scene)), other,
                            computePoints(other), static_cast<int>(i), static_cast<int>(i) + 1});
    }
    DiagramSheet sheet = curveSheet(set);
    if (isHidden) {
      Diagram& diagram = sheet.diagrams.front();
      std::erase_if(diagram.series,
                    [](const DiagramSeries& series) { return series.id <= kPresentCurve; });
      diagram.spans.clear();
      diagram.shades.clear();
      diagram.y.from = step.show.hiddenFrom;
      diagram.y.to = step.show.hiddenTo;
      if (diagram.x.from == diagram.x.to) {
        diagram.x.from = set.present.points.front().velocity;
        diagram.x.to = set.present.points.back().velocity;
        if (!scene.sweep.isOfVelocity()) {
          diagram.x.from = set.present.points.front().swept;
          diagram.x.to = set.present.points.back().swept;
        }
      }
    }
    addSheet(sheet, isHidden ? fromUtf8(Words::tr("an empty chart of friction, to draw into"))
                             : fromUtf8(Words::tr("the friction curve")));
  }

  void addSheet(DiagramSheet sheet, const QString& name) {
    sheet.title = sheet.subtitle = sheet.note = {};
    DiagramOptions options;
    options.width = kChartWidth;
    options.height = kChartHeight;
    options.scale = kPictureScale;
    options.theme = printTheme();
    addPicture(composeDiagrams(sheet, options), name);
  }

  std::vector<CurvePoint> computePoints(const Scene& scene) const {
    CurveOptions options = curveOptions();
    Curve curve = computeCurve(scene, options);
    if (!curve.isComplete) throw StopRequested{};
    return std::move(curve.points);
  }

  CurveOptions curveOptions() const {
    CurveOptions options;
    options.threads = options_.threads;
    options.stop = options_.stop;
    return options;
  }

  void addPicture(const DrawList& list, const QString& name) {
    if (!context_) context_ = makePixelContext();
    blocks_.push_back({{}, Picture{renderImage(*context_, list), name}});
  }

  void addQuestion(const LessonPrediction& prediction) {
    QString html = "<p><b>" + plainText(prediction.question).toHtmlEscaped() + "</b></p>";
    if (prediction.kind == PredictionKind::Choice) {
      for (const LessonChoice& choice : prediction.choices)
        html += "<p>☐ " + plainText(choice.text).toHtmlEscaped() + "</p>";
    } else {
      const QString blank = QStringLiteral("____________________");
      const bool isPoint = prediction.kind == PredictionKind::Point;
      html += "<p>";
      if (isPoint) html += fromUtf8(Words::tr("Mark the place in the chart.")) + ' ';
      html += fromUtf8(Words::tr("My answer")) + ": " + blank;
      // A free point has two numbers.
      if (isPoint && !prediction.x) html += ' ' + fromUtf8(Words::tr("at %1")).arg(blank);
      html += "</p>";
    }
    add(html);
  }

  void addAnswer(const LessonStep& step, int number) {
    const LessonPrediction& prediction = *step.prediction;
    const LessonAnswer answer = lessonAnswer(step, curveOptions());
    const bool hasVerdict = answer.choice >= 0 && prediction.answer && !prediction.right.empty();
    add("<p><b>" + fromUtf8(Words::tr("Answer")) + ":</b> " +
            answerInWords(prediction, answer).toHtmlEscaped() + "</p>",
        step.reveal.empty() && !hasVerdict ? KeepWithNext::No : KeepWithNext::Always);
    // A sentence with the number that decides: "It becomes 1.97 times as large."
    if (hasVerdict)
      add(richText(prediction.right, prediction, answer, {}),
          step.reveal.empty() ? KeepWithNext::No : KeepWithNext::Always);
    if (!step.reveal.empty()) add(richText(step.reveal, prediction, answer, {}));
    // Pictures may go to the next page: else a large part of this one could stay empty. So they say
    // what they belong to.
    const std::size_t caption = blocks_.size();
    add("<p><i>" + fromUtf8(Words::tr("After the answer to step %1")).arg(number + 1) + ":</i></p>",
        KeepWithNext::Always);
    if (!(step.scene == step.revealedScene)) addContact(step.revealedScene);
    if (step.show.hidesCurve && !step.show.hidesCurveAfter)
      addChart(step, step.revealedScene, false);
    if (blocks_.size() == caption + 1) blocks_.pop_back();
  }

  /// Keeps a text with the picture below it, and that picture with another one below.
  void keepTogether(std::size_t text) {
    for (std::size_t i = text; i + 1 < blocks_.size(); ++i)
      blocks_[i].withNext = i == text ? KeepWithNext::Always : KeepWithNext::IfShort;
  }

  const Lesson lesson_;
  const HandoutOptions& options_;
  std::vector<Block> blocks_;
  std::unique_ptr<PixelContext> context_;
  std::optional<Scene> contact_, chart_;                  // shown last
  std::optional<Scene> revealedContact_, revealedCurve_;  // the answers to the last questions
  std::string chartKey_, revealedQuantity_;
};

constexpr const char* kStyle =
    "body{font-family:'DejaVu Sans',sans-serif;line-height:1.45;color:#222;max-width:46em;"
    "margin:2em auto;padding:0 1em}h1{font-size:1.6em}h2{font-size:1.15em;margin-top:1.8em}"
    "img{max-width:100%;border:1px solid #ddd}"
    ".page{border-top:1px solid #ddd;margin-top:3em;break-before:page}"
    "@media print{h1,h2,.stays{break-after:avoid}p,img{break-inside:avoid}body{margin:0}}";

/// The pages on paper. What stays together goes to the next page as a whole, unless it is larger
/// than one.
class HandoutPages {
 public:
  HandoutPages(QPdfWriter& writer, const QString& title, const std::vector<Block>& blocks)
      : writer_(writer), title_(title), blocks_(blocks), painter_(&writer) {
    for (const Block& block : blocks_) parts_.push_back(layOut(block));
  }

  void draw() {
    const std::vector<std::vector<std::size_t>> pages = makePages();
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (i > 0) writer_.newPage();
      double y = 0;
      for (const std::size_t part : pages[i]) {
        y += part == pages[i].front() ? 0 : parts_[part].above;
        drawPart(part, y);
        y += parts_[part].height;
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

  static double dots(double millimetres) { return millimetres / 25.4 * kResolution; }

  Part layOut(const Block& block) const {
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
    part.height = part.text->size().height() + dots(kTextGap);
    return part;
  }

  /// Returns the end of the parts that stay together in any case.
  std::size_t groupEnd(std::size_t first) const {
    std::size_t end = first + 1;
    while (end < parts_.size() && blocks_[end - 1].withNext == KeepWithNext::Always) ++end;
    return end;
  }

  double groupHeight(std::size_t first, std::size_t end) const {
    double height = 0;
    for (std::size_t i = first; i < end; ++i) height += parts_[i].above + parts_[i].height;
    return height;
  }

  /// Returns the parts of each page.
  std::vector<std::vector<std::size_t>> makePages() const {
    const double available = writer_.height() - dots(kFootHeight);
    std::vector<std::vector<std::size_t>> pages(1);
    double used = 0;
    for (std::size_t first = 0; first < parts_.size();) {
      std::size_t end = groupEnd(first);
      double height = groupHeight(first, end);
      while (end < parts_.size() && blocks_[end - 1].withNext == KeepWithNext::IfShort &&
             groupHeight(first, groupEnd(end)) <= kShort * available) {
        end = groupEnd(end);
        height = groupHeight(first, end);
      }
      if (height > available) {
        end = first + 1;
        height = groupHeight(first, end);
      }
      if (used > 0 && (blocks_[first].beginsPage || used + height > available)) {
        pages.emplace_back();
        used = 0;
      }
      for (; first < end; ++first) pages.back().push_back(first);
      used += height;
    }
    return pages;
  }

  void drawPart(std::size_t place, double y) {
    if (const Block& block = blocks_[place]; block.picture) {
      const QSizeF size(dots(kShownWidth), parts_[place].height - dots(kGap));
      painter_.drawImage(QRectF(QPointF(0, y), size), block.picture->image);
      return;
    }
    painter_.save();
    painter_.translate(0, y);
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, Qt::black);  // also where the window is dark
    parts_[place].text->documentLayout()->draw(&painter_, context);
    painter_.restore();
  }

  void drawFoot(const QString& page) {
    painter_.setFont(QFont(QStringLiteral("DejaVu Sans"), 8));
    painter_.setPen(Qt::darkGray);
    const QRectF foot(0, writer_.height() - dots(kFootHeight), writer_.width(), dots(kFootHeight));
    painter_.drawText(foot, Qt::AlignBottom | Qt::AlignLeft, title_);
    painter_.drawText(foot, Qt::AlignBottom | Qt::AlignRight, page);
  }

  QPdfWriter& writer_;
  const QString& title_;
  const std::vector<Block>& blocks_;
  QPainter painter_;
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
  for (const Block& block : HandoutMaker(lesson, options).make()) {
    const bool stays = block.withNext != KeepWithNext::No;
    if (stays) html += block.beginsPage ? "<div class=\"stays page\">" : "<div class=\"stays\">";
    html += block.html.toUtf8();
    if (block.picture)
      html += "<p><img alt=\"" + block.picture->name.toHtmlEscaped().toUtf8() +
              "\" src=\"data:image/png;base64," + pngBytes(block.picture->image).toBase64() +
              "\"></p>";
    html += stays ? "</div>\n" : "\n";
  }
  return html + "</body>\n</html>\n";
}

QByteArray handoutPdf(const Lesson& lesson, const HandoutOptions& options) {
  loadFonts();
  QHashSeed::setDeterministicGlobalSeed();  // it determines the order of fonts in the file
  const std::vector<Block> blocks = HandoutMaker(lesson, options).make();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({kMargin, kMargin, kMargin, kMargin - kFootHeight},
                          QPageLayout::Millimeter);
    writer.setTitle(plainText(lesson.title));
    writer.setCreator(QStringLiteral("Asperity " ASPERITY_VERSION));
    const QString title = plainText(lesson.title);
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

}  // namespace asperity
