//! Many degrees of freedom: eigenproblems, full and banded, and frequency response of a hundred masses.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them. nalgebra is timed in the
//! same run, and NumPy with SciPy where they are installed: their ratio to ours is what can be compared.

use std::{f64::consts::PI, hint::black_box, time::Instant};

use dalembert_mechanics::vibration::{
    modes::natural_modes,
    poles::Poles,
    receptance::{column_of_modes, column_of_poles, sum_of_modes, sum_of_poles},
};
use dalembert_numerics::linalg::{SymmetricBand, generalised_eigen, lowest_modes};
use nalgebra::{Cholesky, Complex, DMatrix, DVector, SymmetricEigen};

#[path = "yardstick/python.rs"]
mod python;

/// NumPy and SciPy on the same work; prints the milliseconds of each row.
const YARDSTICK: &str = "
import os, time, numpy as np, scipy.linalg as sl, scipy.sparse as sp, scipy.sparse.linalg as ssl
def best(f, n):
    t=[]
    for _ in range(n):
        a=time.perf_counter(); f(); t.append(time.perf_counter()-a)
    return min(t)*1e3
def pair(n):
    r=np.random.default_rng(1); a=r.standard_normal((n,n)); b=r.standard_normal((n,n))
    return a@a.T+n*np.eye(n), b@b.T/n+np.eye(n)
for n,reps in ((100,100),(1000,9)):
    k,m=pair(n); print(best(lambda: sl.eigh(k,m), reps))
def chain(n):
    k=1e6*(2*np.eye(n)-np.eye(n,k=1)-np.eye(n,k=-1)); k[-1,-1]=1e6; return k
k=sp.csc_matrix(chain(1000)); print(best(lambda: ssl.eigsh(k,10,sigma=0,which='LM'), 20))
n=100; k=chain(n)
w2,phi=sl.eigh(k); w=np.sqrt(w2); om=np.linspace(1,2200,10000)
d=lambda: 1/(w2[None,:]-om[:,None]**2+.04j*w[None,:]*om[:,None])
print(best(lambda: (d()*(phi[99]*phi[50])[None,:]).sum(1), 5)); print(best(lambda: (d()*phi[99][None,:])@phi.T, 5))
";

fn main() {
    let yardstick: Option<[f64; 5]> = python::figures(YARDSTICK);
    let beside =
        |at: usize| yardstick.as_ref().map_or(String::new(), |ms| format!(", SciPy {:.2} ms", ms[at]));
    for (at, (n, rounds, goal)) in [(100, 100, 0.6), (1000, 9, 130.0)].into_iter().enumerate() {
        let (k, m) = pair(n);
        let ours = best(rounds, || generalised_eigen(&k, &m).expect("the pencil is definite"));
        let found = generalised_eigen(&k, &m).expect("the pencil is definite");
        let balance = &k * &found.vectors - &m * &found.vectors * DMatrix::from_diagonal(&found.values);
        let residual = balance.amax() / (k.amax() * found.vectors.amax());
        assert!(residual < 1e-12, "the residual of {n} modes is {residual}");
        let others = best(3, || nalgebra_eigen(&k, &m));
        println!(
            "modal full K φ = λ M φ, n = {n}, all processors\t{ours:.2} ms (nalgebra {others:.1} ms{})\t< {goal} ms",
            beside(at)
        );
    }

    let (k, m) = chain(1000);
    let ours = best(20, || lowest_modes(&k, &m, 10).expect("the chain has modes"));
    let found = lowest_modes(&k, &m, 10).expect("the chain has modes");
    let exact = 4e6 * (PI / (2.0 * 2001.0)).sin().powi(2);
    let off = ((found.values[0] / exact).sqrt() - 1.0).abs();
    println!("modal lowest 10 of a band, n = 1000\t{ours:.2} ms{}\t< 1 ms", beside(2));
    println!("modal lowest frequency of it, relative error\t{off:.0e}\t< 1e-13");
    let (k, m) = chain(1_000_000);
    let ours = best(1, || lowest_modes(&k, &m, 3).expect("the chain has modes"));
    let found = lowest_modes(&k, &m, 3).expect("the chain has modes");
    let off = (0..3).map(|mode| {
        let exact = 4e6 * (PI * (2.0 * f64::from(mode as u8) + 1.0) / (2.0 * 2_000_001.0)).sin().powi(2);
        ((found.values[mode] / exact).sqrt() - 1.0).abs()
    });
    let off = off.fold(0.0, f64::max);
    assert!(off < 1e-10, "the modes of a million masses are {off} off");
    println!("modal lowest 3 of a band, n = 1000000\t{ours:.0} ms, error {off:.0e}\taccepted");
    clustered();

    frequency_response(&beside);
}

/// Lowest modes of a grid of masses, five by twenty thousand, held at one end, without and with a soft spring from every
/// mass to the ground, so that the squares of the lowest frequencies lie a millionth apart.
fn clustered() {
    const COUNT: usize = 10;
    let [plain, alike] = [0.0, 5e4].map(|ground| {
        let (k, m) = grid(20_000, ground);
        let modes = lowest_modes(&k, &m, COUNT).expect("the grid has modes");
        for (mode, value) in modes.values.iter().enumerate() {
            let wave = PI * (2.0 * mode as f64 + 1.0) / (2.0 * 40_001.0);
            let off = value / (ground + 4e6 * wave.sin().powi(2)) - 1.0;
            assert!(off.abs() < 1e-10, "mode {} of the grid is {off} off", mode + 1);
        }
        let products = modes.vectors.tr_mul(&modes.vectors) - DMatrix::identity(COUNT, COUNT);
        assert!(products.amax() < 1e-10, "the modes are orthogonal to {}", products.amax());
        best(3, || lowest_modes(&k, &m, COUNT).expect("the grid has modes"))
    });
    println!(
        "modal lowest 10 of half band 5, n = 100000, a millionth apart\t{alike:.0} ms, {:.2} of {plain:.0} ms without ground springs\t≤ 2",
        alike / plain
    );
}

/// Masses of 1 kg in rows of five, on springs of 1 MN/m to their neighbours, the first row to the wall.
fn grid(rows: usize, ground: f64) -> (SymmetricBand, SymmetricBand) {
    let n = 5 * rows;
    let mut stiffness = SymmetricBand::zeros(n, 5).expect("the size is accepted");
    for i in 0..n {
        stiffness.add(i, i, ground + if i < 5 { 1e6 } else { 0.0 });
        for before in [(i % 5 > 0).then_some(1), (i >= 5).then_some(5)].into_iter().flatten() {
            stiffness.add(i, i, 1e6);
            stiffness.add(i - before, i - before, 1e6);
            stiffness.add(i, i - before, -1e6);
        }
    }
    (stiffness, SymmetricBand::diagonal(&vec![1.0; n]).expect("the size is accepted"))
}

/// The chain of a hundred masses of the yardstick: 2 % in every mode, the force on the last mass.
fn frequency_response(beside: &dyn Fn(usize) -> String) {
    const N: usize = 100;
    const LINES: usize = 10_000;
    const SEEN: usize = 50;
    let (k, m) = chain(N);
    let full = |band: &SymmetricBand| DMatrix::from_fn(N, N, |i, j| band.get(i, j));
    let modes = natural_modes(&full(&m), &full(&k)).expect("the chain has modes");
    let decays: Vec<f64> = modes.squares.iter().map(|square| 0.04 * square.sqrt()).collect();
    let lines: Vec<f64> = (0..LINES).map(|line| 1.0 + 2199.0 * line as f64 / (LINES - 1) as f64).collect();
    let residues: Vec<f64> =
        (0..N).map(|mode| modes.shapes[(SEEN, mode)] * modes.shapes[(N - 1, mode)]).collect();
    let (mut re, mut im) = (vec![0.0; LINES], vec![0.0; LINES]);
    let one = best(20, || sum_of_modes(&residues, &modes.squares, &decays, &lines, &mut re, &mut im));
    println!("modal response 100 × 10000, one output\t{one:.2} ms{}\t< 0.5 ms", beside(3));
    for (line, printed) in [(0, 5.123625104709e-5), (4999, 2.3276079286e-7), (9999, 8.5533e-13)] {
        let off = (re[line].hypot(im[line]) / printed - 1.0).abs();
        println!("modal response at line {line}, relative error\t{off:.0e}\t< 1e-4");
    }

    let (mut real, mut imaginary) = (DMatrix::zeros(N, LINES), DMatrix::zeros(N, LINES));
    let column = best(7, || {
        column_of_modes(&modes.shapes, N - 1, &modes.squares, &decays, &lines, &mut real, &mut imaginary);
    });
    is_same(SEEN, (&real, &imaginary), (&re, &im));
    println!("modal response 100 × 10000, a column\t{column:.2} ms{}\t< 5 ms", beside(4));

    // A damper at the last mass alone: the modes do not remain.
    let mut damping = DMatrix::zeros(N, N);
    damping[(N - 1, N - 1)] = 200.0;
    let modal = modes.damping(&damping) + DMatrix::from_diagonal(&DVector::from_column_slice(&decays));
    let force = DVector::from_fn(N, |row, _| if row == N - 1 { 1.0 } else { 0.0 });
    let whole = best(3, || {
        let poles = Poles::new(&modes, &modal, 0.0).expect("the poles are simple");
        let input = poles.input(&force);
        column_of_poles(&poles.shapes, &input, &poles.roots, &lines, &mut real, &mut imaginary);
    });
    let poles = Poles::new(&modes, &modal, 0.0).expect("the poles are simple");
    let input = poles.input(&force);
    let column = best(5, || {
        column_of_poles(&poles.shapes, &input, &poles.roots, &lines, &mut real, &mut imaginary);
    });
    let residues: Vec<Complex<f64>> = poles.shapes.row(SEEN).iter().zip(&input).map(|(s, b)| s * b).collect();
    let one = best(10, || sum_of_poles(&residues, &poles.roots, &lines, &mut re, &mut im));
    is_same(SEEN, (&real, &imaginary), (&re, &im));
    println!("modal response, dampers of any kind, one output\t{one:.2} ms\t< 60 ms");
    println!(
        "modal response, dampers of any kind, a column\t{column:.1} ms, poles included {whole:.1} ms\t< 60 ms"
    );
}

/// Compares a row of a column of responses with the response of its coordinate alone.
fn is_same(row: usize, (real, imaginary): (&DMatrix<f64>, &DMatrix<f64>), (re, im): (&[f64], &[f64])) {
    let largest = re.iter().zip(im).map(|(re, im)| re.hypot(*im)).fold(0.0, f64::max);
    for (line, (re, im)) in re.iter().zip(im).enumerate() {
        let off = (real[(row, line)] - re).hypot(imaginary[(row, line)] - im);
        assert!(off <= 1e-12 * largest, "line {line} of the column is {off} off");
    }
}

/// The shortest of some rounds, in milliseconds.
fn best<T>(rounds: usize, mut work: impl FnMut() -> T) -> f64 {
    let once = |work: &mut dyn FnMut() -> T| {
        let start = Instant::now();
        black_box(work());
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..rounds).map(|_| once(&mut work)).fold(f64::INFINITY, f64::min)
}

/// Masses of 1 kg on springs of 1 MN/m, the first one to the wall.
fn chain(n: usize) -> (SymmetricBand, SymmetricBand) {
    let mut stiffness = SymmetricBand::zeros(n, 1).expect("the size is accepted");
    for i in 0..n {
        stiffness.add(i, i, if i + 1 < n { 2e6 } else { 1e6 });
        if i > 0 {
            stiffness.add(i, i - 1, -1e6);
        }
    }
    (stiffness, SymmetricBand::diagonal(&vec![1.0; n]).expect("the size is accepted"))
}

/// Full symmetric matrices of random entries, positive definite.
fn pair(n: usize) -> (DMatrix<f64>, DMatrix<f64>) {
    let mut state = 7_u64;
    let mut normal = || {
        let uniform = |state: &mut u64| {
            *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (*state >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| uniform(&mut state)).sum::<f64>() - 6.0
    };
    let a = DMatrix::from_fn(n, n, |_, _| normal());
    let b = DMatrix::from_fn(n, n, |_, _| normal());
    let one = DMatrix::identity(n, n);
    (&a * a.transpose() + &one * n as f64, &b * b.transpose() / n as f64 + one)
}

#[expect(clippy::disallowed_methods, reason = "the other side of the comparison")]
fn nalgebra_eigen(k: &DMatrix<f64>, m: &DMatrix<f64>) -> DMatrix<f64> {
    let lower = Cholesky::new(m.clone()).expect("M is positive definite").l();
    let half = lower.solve_lower_triangular(k).expect("L is regular");
    let reduced = lower.solve_lower_triangular(&half.transpose()).expect("L is regular");
    let eigen = SymmetricEigen::new(reduced);
    lower.tr_solve_lower_triangular(&eigen.eigenvectors).expect("L is regular")
}
