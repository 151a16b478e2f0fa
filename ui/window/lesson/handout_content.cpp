#include "ui/window/lesson/handout_content.h"

#include <memory>
#include <optional>

#include "core/accuracy/compute_curve.h"
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
#include "core/run/transient_diagram.h"
#include "core/scene/sweep.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/pixel_context.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {

namespace {

// Both pictures have the width of the text and letters of the same size.
constexpr int kPictureWidth = 1660, kContactHeight = 640, kChartHeight = 720;
constexpr float kPictureScale = 2;

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

  std::vector<HandoutBlock> make() {
    addHead();
    for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
      throwIfStopped(options_.stop);
      addStep(static_cast<int>(i));
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
    add(lessonHtml(shown(lesson_.notes)));
  }

  void addStep(int number) {
    const LessonStep& step = lesson_.steps[static_cast<std::size_t>(number)];
    const bool reveals = number > 0 && !options_.forTeacher && mayRevealAnswer(number);
    if (reveals) {
      blocks_.back().withNext = KeepWithNext::Always;
      add("<p><i>" + fromUtf8(Words::tr("Turn the page when you have answered.")) + "</i></p>");
    }
    add(QStringLiteral("<h2>%1. %2</h2>")
            .arg(number + 1)
            .arg(plainText(step.title).toHtmlEscaped()),
        KeepWithNext::Always);
    blocks_.back().beginsPage = reveals;
    add(lessonHtml(shown(step.text)));
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

  /// Returns whether a step may reveal the answer to the question of the step before: on the screen
  /// that answer changed the picture or showed the curve, or the step shows another contact, or it
  /// asks nothing but explains.
  bool mayRevealAnswer(int number) const {
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
    options.width = kPictureWidth;
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
      sheet = withoutCurve(std::move(sheet), step.show.hiddenFrom, step.show.hiddenTo);
      Diagram& diagram = sheet.diagrams.front();
      diagram.marker =
          frameMarker(makeFrame(scene), CurveAxes::Physical, set.y);  // a guess begins there
      if (diagram.x.from == diagram.x.to) {
        diagram.x.from = set.present.points.front().velocity;
        diagram.x.to = set.present.points.back().velocity;
        if (!scene.sweep.isOfVelocity()) {
          diagram.x.from = set.present.points.front().swept;
          diagram.x.to = set.present.points.back().swept;
        }
      }
    }
    QStringList beside;
    for (const auto& curve : set.pinned) beside += translatedText(curve.name);
    addSheet(sheet,
             !isHidden ? fromUtf8(Words::tr("the friction curve"))
             : beside.isEmpty()
                 ? fromUtf8(Words::tr("an empty chart of friction, to draw into"))
                 : fromUtf8(Words::tr("a chart of friction, to draw into, with the curve for %1"))
                       .arg(beside.join(QStringLiteral("; "))));
  }

  void addSheet(DiagramSheet sheet, const QString& name) {
    sheet.title = sheet.subtitle = sheet.note = {};
    DiagramOptions options;
    options.width = kPictureWidth;
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
    blocks_.push_back({{}, HandoutPicture{renderImage(*context_, list), name}});
  }

  void addQuestion(const LessonPrediction& prediction) {
    QString html = "<p><b>" + plainText(prediction.question).toHtmlEscaped() + "</b></p>";
    if (prediction.kind == PredictionKind::Choice) {
      for (const LessonChoice& choice : prediction.choices)
        html += "<p>☐ " + plainText(choice.text).toHtmlEscaped() + "</p>";
    } else {
      const bool isPoint = prediction.kind == PredictionKind::Point;
      // The two of a free point fit into one line.
      const QString blank(isPoint && !prediction.x ? 12 : 20, u'_');
      html += "<p>";
      if (isPoint) html += fromUtf8(Words::tr("Mark the place in the chart.")) + ' ';
      html += fromUtf8(Words::tr("My answer")) + ": " + blank;
      // A free point has two numbers.
      if (isPoint && !prediction.x) html += ' ' + fromUtf8(Words::tr("at %1")).arg(blank);
      html += "</p>";
    }
    add(html);
    blocks_.back().isQuestion = true;
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
      add(lessonHtml(prediction.right, prediction, answer, {}),
          step.reveal.empty() ? KeepWithNext::No : KeepWithNext::Always);
    if (!step.reveal.empty()) add(lessonHtml(step.reveal, prediction, answer, {}));
    // Pictures may go to the next page: else a large part of this one could stay empty. So they
    // have a caption.
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
  std::vector<HandoutBlock> blocks_;
  std::unique_ptr<PixelContext> context_;
  std::optional<Scene> contact_, chart_;                  // shown last
  std::optional<Scene> revealedContact_, revealedCurve_;  // the answers to the last questions
  std::string chartKey_, revealedQuantity_;
};

}  // namespace

std::vector<HandoutBlock> handoutBlocks(const Lesson& lesson, const HandoutOptions& options) {
  return HandoutMaker(lesson, options).make();
}

}  // namespace asperity
