//! Every numerical threshold of the planar kernel, with its unit and the reason of its value.
//!
//! Units: *of the size* is a fraction of [`Model::size`](super::Model::size), m, or of the distance that the bodies
//! reach where that is larger; angles are measured as angle times size. *Relative* is a ratio without unit. ε is the spacing
//! of `f64` at 1, 2.2 × 10⁻¹⁶: a residual is a sum of some ten products, so rounding leaves 2 ε to 50 ε of the size in
//! it. Bounds on the work are counts: they end a search that a well-posed mechanism ends far earlier.
//!
//! A value that is not derived is a choice with room on both sides, and the reason names the sides.

use dalembert_numerics::simd::WIDTH;

// Size of the mechanism.

/// Shortest length that counts as a dimension, m. An arm below a picometre is what rounding leaves of a pin at the
/// centre of mass.
pub(super) const MIN_LENGTH: f64 = 1e-12;

// Initial guess from angles (least squares by Gauss and Newton).

/// Iterations of the initial guess. With the angles fixed most constraints are linear, and two suffice; distances take
/// some more.
pub(super) const GUESS_MAX_ITERATIONS: usize = 20;
/// Regularisation of its normal equations, relative to the row-scaled Jacobian, whose entries are at most 1: it decides
/// only what the constraints leave open.
pub(super) const GUESS_REGULARISATION: f64 = 1e-9;
/// Step at which its iteration has converged, of the size: a guess needs no more digits than the regularisation leaves.
pub(super) const GUESS_STEP: f64 = 1e-9;
/// Spread of the origins from which it starts, of the size: apart, since the distance of coinciding points has no
/// direction, but close together in comparison with the links.
pub(super) const GUESS_SPREAD: f64 = 0.01;
/// Spread, of the size, of the two distant starts, on either side, that look for another solution.
pub(super) const GUESS_FAR_SPREADS: [f64; 2] = [1.0, -1.0];
/// Norm of the residual of another solution over that of the first, up to which it is as good …
pub(super) const GUESS_EQUAL_RESIDUAL: f64 = 2.0;
/// … plus this part of the size: far above its convergence, far below a link.
pub(super) const GUESS_RESIDUAL: f64 = 1e-6;
/// Distance of two origins that are different solutions, of the size: far above the residual, far below what a drawing
/// shows.
pub(super) const GUESS_DISTINCT: f64 = 1e-3;
/// Component of a null-space vector that is a motion, relative to its largest: smaller ones are rounding of the
/// elimination.
pub(super) const GUESS_FREE_COMPONENT: f64 = 1e-6;

// Assembly (Newton's method damped by Levenberg and Marquardt).

/// Residual at which a mechanism is assembled, of the size: 45 ε, what rounding leaves.
pub(super) const ASSEMBLY_RESIDUAL: f64 = 1e-14;
/// Residual with which positions still satisfy the constraints, of the size: ten thousand times that of an assembly, so
/// that positions given to ten digits, or reached next to a singular one, are accepted.
pub(super) const ACCEPTED_RESIDUAL: f64 = 1e-10;
/// Iterations of the assembly; from a drawing on the right branch it takes about ten.
pub(super) const ASSEMBLY_MAX_ITERATIONS: usize = 200;
/// Iterations without progress after which the constraints contradict each other.
pub(super) const ASSEMBLY_MAX_STALLED: usize = 20;
/// Sum of squared residuals over the best so far, below which there is progress.
pub(super) const ASSEMBLY_PROGRESS: f64 = 0.99;
/// Damping of the first iteration, relative to the row-scaled Jacobian, whose entries are at most 1.
pub(super) const ASSEMBLY_DAMPING: f64 = 1e-3;
/// Factor of the damping after an iteration that brings the residuals down, and its lower bound: 5 ε is none.
pub(super) const ASSEMBLY_DAMPING_DECREASE: (f64, f64) = (0.1, 1e-15);
/// Factor of the damping after one that does not, and its lower bound: from none it is back within some iterations.
pub(super) const ASSEMBLY_DAMPING_INCREASE: (f64, f64) = (10.0, 1e-12);

// Continuation from one position to another.

/// Largest displacement of a body in one step, of the size: a turn of 0.2 rad, on which a prediction of second order is
/// off by 10⁻³ and Newton's method converges to the same branch.
pub(super) const MAX_STEP: f64 = 0.2;
/// Smallest step, relative to the whole path: where none that short leads on, the mechanism is at a limit position,
/// which is so found to eleven digits of the path.
pub(super) const MIN_STEP: f64 = 1e-11;
/// Steps of one path: some thirty turns of a crank.
pub(super) const MAX_STEPS: usize = 1_000;
/// Correction over the displacement of its step above which it is a jump to another branch.
pub(super) const MAX_CORRECTION: f64 = 0.1;
/// Correction over the displacement of its step up to which a change of the sign of `det Φ_q` is a passage through a
/// change point on the smooth path: the error of a prediction of second order, where that to the crossing branch is of
/// first order.
pub(super) const MAX_SMOOTH_CORRECTION: f64 = 2e-3;
/// Smallest pivot over the largest below which accelerations are left out of the prediction: the pivot falls with the
/// distance to a change point, and their error is ε over its cube, here a fifth of themselves.
pub(super) const MIN_PIVOT_OF_ACCELERATIONS: f64 = 1e-5;
/// Smallest pivot over the largest below which no step but the last ends: rounding would decide between the branches.
pub(super) const MIN_PIVOT_OF_BRANCH: f64 = 1e-6;
/// Iterations of Newton's method in one step; it converges quadratically, in four or five.
pub(super) const CONTINUATION_MAX_ITERATIONS: usize = 12;
/// Rounding of a position, of the size; drivers that are so close to their values are there already.
pub(super) const POSITION_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Residual in multiples of [`POSITION_ROUNDING`] at which nothing is left to correct.
pub(super) const ROUNDINGS_OF_RESIDUAL: f64 = 4.0;
/// Correction in multiples of the rounding that is allowed even if the step is shorter than that.
pub(super) const ROUNDINGS_OF_CORRECTION: f64 = 16.0;
/// Correction in multiples of [`POSITION_ROUNDING`] up to which an iteration without progress has converged: near a
/// change point the rounding of the residuals makes corrections that are much larger than it.
pub(super) const ROUNDINGS_OF_STALLED_CORRECTION: f64 = 1e3;

// Sweep: continuation on a fixed elimination, several positions at once.

/// Values below which a sweep is not divided among SIMD lanes: the way to the start of each lane would cost more.
pub(super) const MIN_DIVIDED: usize = 4 * WIDTH;
/// Largest displacement of a body in one step that is predicted from earlier positions too, of the size: such a
/// prediction is of the fifth order at least, and beyond [`MAX_STEP`] it has to be right to [`MAX_SMOOTH_CORRECTION`].
pub(super) const MAX_PREDICTED_STEP: f64 = 0.5;
/// Smallest step, relative to the distance of two values: the general continuation takes over.
pub(super) const SWEEP_MIN_STEP: f64 = 1e-3;
/// Iterations of Newton's method in one step.
pub(super) const SWEEP_MAX_ITERATIONS: usize = 8;
/// Residual at which the loops are closed, of the size: the rounding of the two origins and two arms of a pin.
pub(super) const SWEEP_RESIDUAL: f64 = 4.0 * f64::EPSILON;
/// Residual at which they are closed once Newton's method makes no progress, of the size.
pub(super) const SWEEP_STALLED_RESIDUAL: f64 = 1e-13;
/// Residual at which they are closed in a position that is only passed, of the size: the branch is certain, and the
/// position itself is not an answer.
pub(super) const SWEEP_PASSED_RESIDUAL: f64 = 1e-5;
/// Smallest pivot over the largest of the loop equations below which a position is left to the general continuation:
/// without pivoting they lose that many digits.
pub(super) const SWEEP_MIN_PIVOT: f64 = 1e-9;
/// Earlier positions of which the derivatives enter a prediction, at most: with two its error is of the seventh order
/// of the step, and further ones cost more than the iteration that they save.
pub(super) const HISTORY: usize = 2;
/// Step over the one before it beyond which the earlier position is left out: extrapolated further, the polynomial is
/// worse than Taylor's series.
pub(super) const MAX_STEP_GROWTH: f64 = 2.0;

// Elimination of the constraint Jacobian by a remembered order of pivots.

/// Pivot over the largest entry of its row from which it may be selected (threshold pivoting): growth of the entries by
/// at most 1/0.3 in one step, for the freedom to choose few operations.
pub(super) const MIN_SELECTED_PIVOT: f64 = 0.3;
/// Pivot over the largest other entry of its row below which another order is selected: a tenth of the above, so that
/// an order lasts for a good part of a turn.
pub(super) const MIN_KEPT_PIVOT: f64 = 0.03;
/// Pivot over the largest other entry of its row below which a step is rejected: errors are multiplied by a hundred.
pub(super) const MIN_PIVOT_OF_STEP: f64 = 0.01;
/// Pivot over its value when it was selected, below which the position is near a singular one if the rest of its row
/// has fallen as well.
pub(super) const NEAR_SINGULAR_PIVOT: f64 = 0.05;
/// Pivot over its value when it was selected, below which it may vanish within one step and is extrapolated.
pub(super) const FALLING_PIVOT: f64 = 0.5;
/// Pivot over its value when it was selected, below which velocities that follow from the positions are not shown: the
/// tolerance of a step, divided by the pivot, would show.
pub(super) const MIN_PIVOT_OF_VELOCITIES: f64 = 0.01;
/// Largest entry left of a row over its largest before, up to which the row depends on others: the square root of ε.
pub(super) const DEPENDENT_ROW: f64 = 1e-8;
/// The same, from which a row that was dependent is independent; ten times, so that it does not change back at once.
pub(super) const INDEPENDENT_ROW: f64 = 10.0 * DEPENDENT_ROW;
/// Orders of pivots that are remembered: a turn needs two or three for each loop.
pub(super) const MAX_ORDERS: usize = 16;

// Integration of the motion.

/// Residual to which the constraints are satisfied after each step, of the size: the rounding of one coordinate.
pub(super) const MOTION_RESIDUAL: f64 = 2.0 * f64::EPSILON;
/// The same near a singular position, where to correct what is rounding would move the mechanism far.
pub(super) const MOTION_SINGULAR_RESIDUAL: f64 = 32.0 * f64::EPSILON;
/// Residual that is accepted when Newton's method makes no progress or its iterations are used up, of the size.
pub(super) const MOTION_STALLED_RESIDUAL: f64 = 1e-12;
/// Iterations of Newton's method after a step; the step is predicted to its tolerance, so one or two suffice.
pub(super) const MOTION_MAX_ITERATIONS: usize = 6;
/// Residual over that before it above which an iteration makes no progress; quadratic convergence gives far less.
pub(super) const STALLED_RESIDUAL: f64 = 0.3;
/// Correction after a step that is a jump to another branch, of the size …
pub(super) const MOTION_MAX_CORRECTION: f64 = 1e-5;
/// … and in multiples of the tolerance of the step, of which the larger counts.
pub(super) const MOTION_MAX_CORRECTION_IN_TOLERANCES: f64 = 100.0;
/// Rounding in multiples of ε that each loop adds to a position near a singular one, before it is divided by the square
/// of the fallen pivot: once for the positions and again for the velocities that follow from them.
pub(super) const SINGULAR_ROUNDING: f64 = 4.0;
/// Largest tolerance of a step near a singular position, of the size: shorter steps would only come closer to it.
pub(super) const MAX_SINGULAR_TOLERANCE: f64 = 1e-9;
/// Distance ahead at which the Jacobian is evaluated to extrapolate where a row vanishes, of the size: of the
/// difference quotient rounding leaves eleven digits and curvature five.
pub(super) const SINGULARITY_LOOKAHEAD: f64 = 1e-5;
/// Tolerance of a step on a degenerate elimination, of the size: none can satisfy it, so the step is shortened until it
/// ends where another order is selected.
pub(super) const DEGENERATE_TOLERANCE: f64 = 1e-60;
/// Pivot of the reduced mass matrix over its diagonal, up to which a free motion has no inertia: 450 ε, the rounding of
/// its sums.
pub(super) const MASSLESS_PIVOT: f64 = 1e-13;
/// Distance from the given positions within which they satisfy the constraints, of the size.
pub(super) const START_DISTANCE: f64 = 1e-9;
/// Parts of a step between the moments from which one near a singular position is interpolated: without those that are
/// too close to it, a polynomial of the seventh or eighth degree remains, as accurate as the integrator.
pub(super) const INTERPOLATION_PARTS: u32 = 11;
/// Distance of these moments from the singular one, in parts: closer ones carry its rounding.
pub(super) const INTERPOLATION_GAP: f64 = 2.0;

// Coulomb friction.

/// Sliding speed that is rest, relative to the largest velocity, and change of a friction margin that is none, relative
/// to its size: far above rounding, far below what is shown …
pub(super) const REST_SPEED: f64 = 1e-9;
/// … and in multiples of the integrator's tolerance, of which the larger counts.
pub(super) const REST_SPEED_IN_TOLERANCES: f64 = 100.0;
/// Iterations of Newton's method for the friction forces; they are piecewise linear but for the pins.
pub(super) const FRICTION_MAX_ITERATIONS: usize = 30;
/// Step at which they have converged, relative to the largest: 45 ε …
pub(super) const FRICTION_STEP: f64 = 1e-14;
/// … during so many iterations, …
pub(super) const FRICTION_STRICT_ITERATIONS: usize = 8;
/// … and this step afterwards, where rounding does not allow the first.
pub(super) const FRICTION_STALLED_STEP: f64 = 1e-10;
/// Normal force with which a guide changes the side it bears on, relative to the largest: below it the side is
/// rounding.
pub(super) const MIN_SIDE_FORCE: f64 = 1e-10;
/// Sweeps of the projected Gauss–Seidel method over all joints at rest, in turn, until its guess leads to a solution;
/// it converges linearly.
pub(super) const GAUSS_SEIDEL_SWEEPS: [usize; 5] = [0, 30, 300, 3_000, 30_000];
/// Sliding acceleration that is rest in that guess, relative to the largest; a wrong guess is corrected.
pub(super) const GAUSS_SEIDEL_REST: f64 = 1e-5;
/// Sliding velocity over that of the bodies, in every free motion, below which friction cannot hold a joint, as it is
/// at a dead centre: the acceleration by its own friction goes with the square, 45 ε.
pub(super) const DEAD_CENTRE_SLIDING: f64 = 1e-7;
/// Difference of two slidings, relative, up to which they are proportional.
pub(super) const PROPORTIONAL_SLIDING: f64 = 1e-9;
/// Motions out of rest that are tried: they are the combinations of the joints at rest, whose number soon exceeds any
/// time for them.
pub(super) const MAX_STARTING_MOTIONS: usize = 10_000;

// Equilibrium.

/// Largest step of a driver, of the size: as for [`MAX_STEP`].
pub(super) const EQUILIBRIUM_MAX_STEP: f64 = 0.2;
/// Iterations of Newton's method on the holding efforts.
pub(super) const EQUILIBRIUM_MAX_ITERATIONS: usize = 100;
/// Step at which it has converged, of the size: 450 ε.
pub(super) const EQUILIBRIUM_STEP: f64 = 1e-13;
/// Effort over the largest on the way that is none, if rounding keeps the last steps above the first measure.
pub(super) const EQUILIBRIUM_EFFORT: f64 = 1e-9;
/// Stiffness that is rounding of the efforts, relative to the largest effort over the size (or over 1 rad).
pub(super) const ZERO_STIFFNESS: f64 = 1e-10;
/// Lowest eigenvalue of the stiffness, scaled to a diagonal of ±1, that is neutral: the eigenvalues of such a matrix
/// are accurate to some ε, its entries to 10⁻¹⁰.
pub(super) const NEUTRAL_EIGENVALUE: f64 = 1e-9;

// Instant centres.

/// Relative velocity that is none, relative to the largest velocity: ε over [`MIN_PIVOT_OF_BRANCH`], the rounding of
/// velocities next to a change point.
pub(super) const RELATIVE_REST: f64 = 1e-10;
