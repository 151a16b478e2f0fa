// One pass over a line for elements with arms (standard solid, Prony series with or without a
// dashpot of its own): from its lowest point, where the arms' strains are given, around to it
// again. In contact the strains of the arms are integrated exactly along the cubics of the line;
// the free surface creeps back as a sum of exponentials. Contact edges are found inside of
// segments, so friction converges as for one relaxation time: at second order for linear and at
// fourth order for cubic segments. Strains and the recovery of the free surface are stored by
// themselves and not as differences of depths, which may be many orders of magnitude larger.
// Cost: some flops per element in contact and arm; free blocks are skipped.
// Ownership: keeps its workspace; refers to line and coefficients. Threading: one thread at a time.
#pragma once

#include <span>
#include <vector>

#include "core/contact/arms/arm_coefficients.h"
#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Shape and amplitudes at the nodes, in travel order.
struct ArmShape {
  NodeShape nodes;            // pressure: p / 4G
  std::vector<double> modes;  // m, [node][mode]: amplitudes a_j, in contact too
};

/// Returns the turning points of a cubic inside (0, 1) in order of travel, and then `to`. Between
/// two of them the cubic only rises or only falls.
StaticVector<3> turningPoints(double to, const Cubic& cubic, bool onwards);

/// Counts free intervals. Where the pressure is 0 to rounding as contact begins, contact ends and
/// begins again within a few digits of the position: such short intervals, contact or free, are not
/// counted.
class FreeIntervals {
 public:
  /// Begins in contact, which continues from that at the line's end. spacing: m, of the line's
  /// segments.
  void begin(double spacing) {
    least_ = 1e-6 * spacing;
    contact_ = spacing;
    count_ = 0;
  }
  /// Adds a contact and the free arc after it, of these lengths (m).
  void add(double contact, double arc) {
    contact_ += contact;
    if (!(arc > least_)) return;
    count_ += contact_ > least_ ? 1 : 0;
    contact_ = 0;
  }
  double count() const { return count_; }

 private:
  double least_ = 0, contact_ = 0, count_ = 0;
};

class ArmPass {
 public:
  ArmPass(const PreparedProfile& line, const ArmCoefficients& coefficients);

  /// Computes what the balance needs: sums().depth and creepChange(); with `tangent` also their
  /// derivatives. depth and strain: m.
  void run(double depth, std::span<const double> strain, ArmTangent* tangent = nullptr);
  /// Computes all sums.
  void runForState(double depth, std::span<const double> strain, ArmShape* shape = nullptr);

  /// Computes the arms' strains (m) at the lowest point in complete contact. They do not depend on
  /// the depth: each is the driving of one period over the part of the strain that is forgotten in
  /// it.
  void completeStrains(std::span<double> strain);
  /// Returns whether contact was complete in the last pass.
  bool wasComplete() const { return !hasLeft_; }

  /// Returns the sums per 4G, where G is the equilibrium modulus. Pressure, work and dissipation
  /// are summed separately; all terms of the last one are positive.
  const PassSums& sums() const { return sums_; }
  /// Returns the creep of the arms over the period (m); it is 0 in steady sliding.
  const std::vector<double>& creepChange() const { return creepChange_; }

 private:
  /// A segment that is examined inside: its height over t in [0, 1], s = start + t along. The last
  /// one is measured back from its end, the lowest point: contact there may be far shorter than the
  /// segment.
  struct Inside {
    Cubic height;
    double start, along;
    double at(double t) const { return start + t * along; }
  };

  /// A part of a segment in contact: w over u in [0, 1], in the direction of travel.
  struct Piece {
    Cubic depth;
    double length, start;
  };

  template <bool Everything>
  void runPass(double depth, std::span<const double> strain, ArmShape* shape);
  template <bool Everything>
  std::size_t contactSegment(std::size_t i);
  template <bool Everything>
  std::size_t freeSegments(std::size_t i, bool mayJump);
  template <bool Everything>
  void inspectSegment(std::size_t i);
  template <bool Everything>
  double followContact(const Inside& inside, double from, double to);
  void enter(double position, double height);
  template <bool Everything>
  void leave(double position, double height);

  Inside makeInside(std::size_t i) const;
  Piece makePiece(const Inside& inside, double from, double to) const;
  ValueAndSlope pressureAt(const Piece& piece, double u) const;
  double findSeparation(const Piece& piece) const;
  void advance(const Piece& piece, double u);
  void gatherPiece(const Piece& piece, double u);
  void gatherContact(const Piece& piece, double withStrain0, double withStrain1, double withStrain2,
                     const std::array<std::array<double, 3>, 3>& own);
  template <bool Everything>
  void gatherArc(double position);
  double recovery(double distance) const;
  ValueAndSlope clearanceAt(const Inside& inside, double from, double t) const;
  double findEntry(const Inside& inside, double from, double to, double lowest) const;
  void refreshSums();
  void setStrainsFree();
  void setModes(double* modes, double depth) const;
  double elasticWork(double height) const;
  void addCreep(const Piece& piece, double u);
  void record(std::size_t i, ArmShape& shape);

  const PreparedProfile& line_;
  const ArmCoefficients& coefficients_;
  double depth_ = 0;
  bool touching_ = true, hasLeft_ = false;
  std::size_t level_ = 0;               // of the block tried next
  std::vector<double> strain_, next_;   // m, e_i in contact
  std::vector<double> mode_, arcMode_;  // m, a_j now and where the arc began
  std::vector<double> creepChange_;     // m
  double strainSum_ = 0, lossSum_ = 0;  // sum g_i e_i (m), sum g_i e_i / c_i
  double arcStart_ = 0;                 // m
  double contactStart_ = 0;             // m
  double entryHeight_ = 0;              // m, of the line where the present contact began
  double leftHeight_ = 0;               // m, of the line where the present arc began
  double recovered_ = 0;                // m, that the free surface has come back since
  PassSums sums_;
  FreeIntervals free_;
  ArmTangent* tangent_ = nullptr;
};

}  // namespace asperity
