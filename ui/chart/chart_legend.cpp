#include "ui/chart/chart_legend.h"

#include <QEnterEvent>
#include <QEvent>
#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

namespace {

constexpr double kSide = 16, kMargin = 4;  // beside the entries, and above and below them
constexpr double kSample = 22;             // width of a sample of a mark, pixels
constexpr double kSampleGap = 6;           // between a sample and its name
constexpr double kCross = 16;              // of the button that unpins a curve
constexpr double kGap = 18;                // between entries
constexpr int kMaxRows = 3;
constexpr int kMaxLines = 2;  // of one entry

/// Shortens a name to its first parts: "mean of 200 lines" instead of "mean of 200 lines ± standard
/// error". Only a part that is itself too long is cut within a word.
QString firstParts(const QString& name, double available, const QFontMetricsF& metrics) {
  if (metrics.horizontalAdvance(name) <= available) return name;
  for (qsizetype at = name.size(); at > 0; --at) {
    const QStringView rest = QStringView(name).mid(at);
    const auto isEnd = [&](const char* mark) { return rest.startsWith(QString::fromUtf8(mark)); };
    if (!isEnd(", ") && !isEnd("; ") && !isEnd(" ± ")) continue;
    if (metrics.horizontalAdvance(name.left(at)) <= available) return name.left(at);
  }
  return metrics.elidedText(name, Qt::ElideRight, available);
}

/// Breaks a text that is too long for its space into lines, after commas, or the semicolons of a
/// language with decimal commas.
QStringList brokenInto(const QString& text, double available, const QFontMetricsF& metrics) {
  QStringList lines(1);
  static const QRegularExpression gap(QStringLiteral("(?<=[,;]) "));
  for (const QString& part : text.split(gap)) {
    const QString longer = lines.last().isEmpty() ? part : lines.last() + ' ' + part;
    const bool fits = metrics.horizontalAdvance(longer) <= available || lines.last().isEmpty();
    if (fits || lines.size() == kMaxLines)
      lines.last() = longer;
    else
      lines += part;
  }
  for (QString& line : lines) line = metrics.elidedText(line, Qt::ElideRight, available);
  return lines;
}

}  // namespace

ChartLegend::ChartLegend(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setMouseTracking(true);
  setObjectName("chartLegend");
  keepTranslated(*this, [this] { setAccessibleName(tr("legend of the chart")); });
  arrange();
}

void ChartLegend::show(const DiagramSheet& sheet, const DiagramSheet& english,
                       const ChartStyle& style, double available) {
  sheet_ = sheet;
  english_ = english;
  style_ = style;
  available_ = available;
  arrange();
  update();
}

/// Returns the entries: the present curve, the marker, theory, the curves of other diagrams, and
/// the pinned curves in their order. The marker has a short name, for which the first row has
/// space.
std::vector<ChartLegend::Entry> ChartLegend::makeEntries() const {
  std::vector<Entry> first, theory, marker, others, pinned;
  for (std::size_t i = 0; i < sheet_.diagrams.size(); ++i) {
    const Diagram &diagram = sheet_.diagrams[i], &english = english_.diagrams[i];
    for (std::size_t k = 0; k < diagram.series.size(); ++k) {
      const DiagramSeries& series = diagram.series[k];
      if (series.name.empty() || !hasPoints(series, diagram)) continue;
      Entry entry;
      entry.explanation = findExplanation(english.series[k].name);
      entry.text = QString::fromStdString(series.name.text);
      entry.hasBars = hasErrorBars(series);
      entry.series = series;
      entry.series.points.clear();
      auto& group = series.isTheory              ? theory
                    : series.id == kPresentCurve ? first
                    : series.id > kPresentCurve  ? pinned
                                                 : others;
      group.push_back(std::move(entry));
    }
    if (!diagram.marker || diagram.marker->name.empty()) continue;
    Entry entry;
    entry.text = QString::fromStdString(diagram.marker->name.text);
    entry.series.isFaded = diagram.marker->isFaded;
    entry.isMarker = true;
    if (english.marker) entry.explanation = findExplanation(english.marker->name);
    marker.push_back(std::move(entry));
  }
  for (auto* group : {&marker, &theory, &others, &pinned})
    std::move(group->begin(), group->end(), std::back_inserter(first));
  return first;
}

QRectF ChartLegend::entryRect(int id) const {
  for (const Entry& entry : entries_)
    if (entry.series.id == id) return entry.box;
  return {};
}

QStringList ChartLegend::entryLines(int id) const {
  for (const Entry& entry : entries_)
    if (entry.series.id == id) return entry.lines;
  return {};
}

double ChartLegend::rowHeight() const {
  return QFontMetricsF(font()).height() + 6;
}

double ChartLegend::sampleWidth() const {
  return (kSample + kSampleGap) * markScale(font());
}

/// Returns the width of the status at the end of its work: "37 of 200" is as wide as "200 of 200",
/// so that the entries beside it do not move while it counts.
double ChartLegend::statusWidth() const {
  static const QRegularExpression number(QStringLiteral("\\d+"));
  QString text = QString::fromStdString(sheet_.status.text), longest;
  for (auto found = number.globalMatch(text); found.hasNext();)
    if (const QString one = found.next().captured(); one.size() > longest.size()) longest = one;
  return QFontMetricsF(font()).horizontalAdvance(text.replace(number, longest));
}

/// Places the entries in as few rows as the chart leaves, with shorter names where that is enough:
/// the tooltip has the whole ones. Where it is not, there are more rows, up to a limit. Returns how
/// many entries did not fit.
int ChartLegend::fit() {
  constexpr std::array kNarrower{0.45, 0.3, 0.2};  // widest name, part of the legend's width
  const auto few = static_cast<int>((available_ - 2 * kMargin) / rowHeight());
  int missing = 0;
  for (int rows = std::clamp(few, 1, kMaxRows); rows <= kMaxRows; ++rows) {
    if ((missing = place(rows, std::nullopt)) == 0) return 0;
    for (const double part : kNarrower)
      if ((missing = place(rows, part * width())) == 0) return 0;
  }
  return missing;
}

/// Arranges the entries in rows; the first row ends at the status. The last entry shows how many
/// did not fit. The legend keeps its height while a curve is computed: the first result, of one
/// line, has a shorter name, and the chart would move for a moment.
void ChartLegend::arrange() {
  const int missing = fit();
  const double height = rowHeight();
  if (missing > 0) {
    Entry rest;
    rest.text = tr("and %n more", nullptr, missing);
    rest.lines = {rest.text};
    rest.hasSample = false;
    const QRectF last = entries_.empty() ? QRectF(0, kMargin, 0, height) : entries_.back().box;
    rest.box = QRectF(last.right() + kGap * markScale(font()), last.bottom() - height, 120, height);
    entries_.push_back(std::move(rest));
  }
  const bool isEmpty = entries_.empty() && sheet_.status.empty();
  const double bottom = entries_.empty() ? kMargin + height : entries_.back().box.bottom();
  int all = isEmpty ? 0 : static_cast<int>(bottom + kMargin);
  if (sheet_.isGrowing) all = std::max(all, minimumHeight());
  if (minimumHeight() != all || maximumHeight() != all) setFixedHeight(all);
}

/// Places the entries in this many rows, names in one line of at most this width, or in up to two
/// lines where none is given. Returns how many entries did not fit.
int ChartLegend::place(int rows, std::optional<double> widestName) {
  const QFontMetricsF metrics(font());
  const double height = rowHeight();
  entries_.clear();
  double x = kSide, y = kMargin;
  int row = 0, missing = 0;
  const auto end = [&] { return width() - kSide - (row == 0 ? statusWidth() + kGap : 0); };
  const auto add = [&](Entry entry, double extra) {
    const double available = std::max(40.0, width() - 2 * kSide - sampleWidth() - extra);
    // Curves that were pinned may differ in the last parts of their names.
    const double narrow = std::min(available, widestName.value_or(available));
    if (!widestName)
      entry.lines = brokenInto(entry.text, available, metrics);
    else if (entry.isPinned())
      entry.lines = {metrics.elidedText(entry.text, Qt::ElideRight, narrow)};
    else
      entry.lines = {firstParts(entry.text, narrow, metrics)};
    double widest = 0;
    for (const QString& part : entry.lines)
      widest = std::max(widest, metrics.horizontalAdvance(part));
    const double wide = sampleWidth() + widest + extra;
    const auto more = static_cast<int>(entry.lines.size()) - 1;
    const bool isNewRow = x + wide > end() && (x > kSide || row == 0);
    if (missing > 0 || row + (isNewRow ? 1 : 0) + more >= rows) {
      ++missing;
      return;
    }
    if (isNewRow) {
      ++row;
      x = kSide;
      y += height;
    }
    entry.box = QRectF(x, y, wide, height * (more + 1));
    row += more;
    y += more * height;
    x += wide + kGap * markScale(font());
    entries_.push_back(std::move(entry));
  };
  for (Entry& entry : makeEntries()) {
    const double extra = entry.isPinned() ? kCross * markScale(font()) : 0;
    add(std::move(entry), extra);
  }
  return missing;
}

/// Returns the full name, which may be shortened, with what it means or the effect of a click.
QString ChartLegend::tipAt(QPointF position) const {
  const Entry* entry = entryAt(position);
  if (!entry) return {};
  if (entry->isPinned()) return entry->text + '\n' + tr("Click to unpin this curve");
  if (entry->explanation) return explanationHtml(*entry->explanation, entry->text);
  return entry->lines.join(' ') != entry->text ? entry->text : QString();
}

const ChartLegend::Entry* ChartLegend::entryAt(QPointF position) const {
  const auto found = std::ranges::find_if(
      entries_, [position](const Entry& entry) { return entry.box.contains(position); });
  return found == entries_.end() ? nullptr : &*found;
}

void ChartLegend::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void ChartLegend::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) arrange();
}

const ChartLegend::Entry* ChartLegend::pinAt(QPointF position) const {
  const Entry* entry = entryAt(position);
  return entry && entry->isPinned() ? entry : nullptr;
}

void ChartLegend::mouseMoveEvent(QMouseEvent* event) {
  const Entry* pin = pinAt(event->position());
  const int under = pin ? pin->series.id : 0;
  setCursor(pin ? Qt::PointingHandCursor : Qt::ArrowCursor);
  setToolTip(tipAt(event->position()));
  const Entry* entry = entryAt(event->position());
  emit pointedAt(entry && entry->explanation ? anchorText(*entry->explanation) : QString());
  if (under == under_) return;
  under_ = under;
  update();
}

void ChartLegend::enterEvent(QEnterEvent* event) {
  QWidget::enterEvent(event);
  emit entered();
}

void ChartLegend::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  under_ = 0;
  update();
}

void ChartLegend::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mouseReleaseEvent(event);
  if (const Entry* pin = pinAt(event->position())) emit unpinRequested(pin->series.id);
}

void ChartLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), style_.background());
  paintStatus(painter);
  for (const Entry& entry : entries_) paintEntry(painter, entry);
}

/// Paints the status at the right end of the first row.
void ChartLegend::paintStatus(QPainter& painter) const {
  painter.setPen(style_.faintText());
  painter.drawText(QRectF(0, kMargin, width() - kSide, rowHeight()),
                   Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(sheet_.status.text));
}

void ChartLegend::paintEntry(QPainter& painter, const Entry& entry) const {
  const QRectF& box = entry.box;
  const double scale = markScale(font());
  const double height = box.height() / static_cast<double>(entry.lines.size());
  const QPointF centre(box.left() + kSample * scale / 2, box.top() + height / 2);
  const bool isUnder = entry.isPinned() && entry.series.id == under_;
  if (isUnder) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(style_.span());
    painter.drawRoundedRect(box.adjusted(-4, 0, 4, 0), 4, 4);
  }
  if (entry.hasSample) paintSample(painter, entry, centre);
  painter.setPen(entry.hasSample ? style_.text() : style_.faintText());
  for (qsizetype i = 0; i < entry.lines.size(); ++i)
    paintText(painter,
              QRectF(box.left() + sampleWidth(), box.top() + static_cast<double>(i) * height,
                     box.width(), height),
              Qt::AlignLeft | Qt::AlignVCenter, entry.lines[i]);
  if (!entry.isPinned()) return;
  painter.setPen(isUnder ? style_.text() : style_.faintText());
  painter.drawText(QRectF(box.left(), box.top(), box.width(), height),
                   Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("✕"));
}

void ChartLegend::paintSample(QPainter& painter, const Entry& entry, QPointF centre) const {
  const double scale = markScale(font());
  // In the middle of a pixel an error bar is sharp, and lies under its mark.
  centre.setX(std::floor(centre.x()) + 0.5);
  const DiagramSeries& series = entry.series;
  const QColor colour = entry.isMarker ? style_.marker() : style_.curve(series);
  painter.setOpacity(series.isFaded ? kFadedOpacity : 1);
  if (entry.isMarker) {
    painter.setPen(QPen(colour, 1.4 * scale));
    painter.drawLine(centre - QPointF(0, 8 * scale), centre + QPointF(0, 8 * scale));
  } else {
    painter.setPen(curvePen(series, style_));
    painter.drawLine(centre - QPointF(kSample * scale / 2, 0),
                     centre + QPointF(kSample * scale / 2, 0));
    painter.setPen(QPen(colour, 1.3 * scale));
    if (entry.hasBars)
      paintErrorBar(painter, centre.x(), centre.y() - 7 * scale, centre.y() + 7 * scale,
                    3.5 * scale);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  if (entry.isMarker || series.mark != SeriesMark::None)
    paintMark(painter, series.mark, centre, (entry.isMarker ? 9 : 7.2) * scale);
  painter.setOpacity(1);
}

}  // namespace asperity
