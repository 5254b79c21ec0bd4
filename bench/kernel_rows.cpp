#include "bench/kernel_rows.h"

#include <dlfcn.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "core/base/large_array.h"
#include "core/base/simd_target.h"
#include "core/factor/cholesky.h"
#include "core/factor/dense_kernels.h"

namespace wend {
namespace {

// Columns of supernodes and the median of their rows, in the elimination trees of the cases 2d-40k (the first
// two) and 3d-20k.
struct FrontSize {
    int columns, rows;
};
constexpr FrontSize kFronts[] = {{12, 50},    {24, 110},   {48, 375},  {96, 580},
                                 {192, 1020}, {384, 1700}, {768, 2380}};
// A measurement takes so many operations at least: the clock is too coarse for one small front.
constexpr double kLeastWork = 4e6;

class RestoredTarget {
  public:
    RestoredTarget() = default;
    ~RestoredTarget() { setSimdTarget(m_target); }
    RestoredTarget(const RestoredTarget&) = delete;
    RestoredTarget& operator=(const RestoredTarget&) = delete;

  private:
    SimdTarget m_target = simdTarget();
};

/// The BLAS and LAPACK of CHOLMOD, in Fortran's convention; functions that are missing are null.
template <class Real>
struct Blas {
    using Potrf = void(const char*, const int*, Real*, const int*, int*);
    using Trsm = void(const char*, const char*, const char*, const char*, const int*, const int*, const Real*,
                      const Real*, const int*, Real*, const int*);
    using Syrk = void(const char*, const char*, const int*, const int*, const Real*, const Real*, const int*,
                      const Real*, Real*, const int*);
    static constexpr bool kSingle = std::is_same_v<Real, float>;

    Potrf* potrf = function<Potrf>(kSingle ? "spotrf_" : "dpotrf_");
    Trsm* trsm = function<Trsm>(kSingle ? "strsm_" : "dtrsm_");
    Syrk* syrk = function<Syrk>(kSingle ? "ssyrk_" : "dsyrk_");

    bool isThere() const { return potrf && trsm && syrk; }

  private:
    template <class Function>
    static Function* function(const char* name) {
        return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));  // NOLINT: the way of dlsym
    }
};

/// Copies of one front, enough for a measurement: panels of a diagonally dominant matrix and an update
/// matrix.
template <class Real>
class Fronts {
  public:
    explicit Fronts(FrontSize size)
        : m_size(size),
          m_copies(static_cast<int>(std::clamp(kLeastWork / flops(), 1.0, 64.0))),
          m_original(panelSize() + dense::kPad<Real>),
          m_panels(m_copies * panelSize() + dense::kPad<Real>),
          m_update(static_cast<std::size_t>(updateLeading()) * below() + dense::kPad<Real>),
          m_inverse(size.columns),
          m_w(leading()),
          m_x(size.columns) {
        for (int c = 0; c < size.columns; ++c)
            for (int r = c; r < size.rows; ++r)
                m_original.data()[static_cast<std::size_t>(c) * leading() + r] =
                    r == c ? Real(2) : Real((7 * r + 3 * c) % 16 - 8) / static_cast<Real>(16 * size.rows);
    }

    int copies() const { return m_copies; }
    int below() const { return m_size.rows - m_size.columns; }
    /// Returns the multiplications and additions of the panel and of the lower triangle of its update matrix.
    double flops() const {
        const double columns = m_size.columns, rows = below();
        return columns * (columns * columns / 3 + rows * columns + rows * rows);
    }
    /// Returns the bytes that a forward and a backward solve read.
    double solveBytes() const {
        return 2.0 * sizeof(Real) * m_size.columns * (m_size.rows - 0.5 * m_size.columns);
    }
    void restore() {
        for (int i = 0; i < m_copies; ++i) std::copy_n(m_original.data(), panelSize(), panel(i));
    }
    void factor(const dense::Kernels<Real>& kernels) {
        for (int i = 0; i < m_copies; ++i) {
            kernels.factorColumns(panel(i), leading(), 0, m_size.columns, leading(), m_inverse.data());
            kernels.squareNegated(panel(i) + m_size.columns, leading(), m_size.columns, m_update.data(),
                                  updateLeading(), 0, below());
        }
    }
    void prepareSolves(const dense::Kernels<Real>& kernels) {
        restore();
        factor(kernels);
        for (int i = 0; i < m_copies; ++i)
            kernels.prepareSolves(panel(i), leading(), m_size.columns, 0, leading(), m_inverse.data());
    }
    void solve(const dense::Kernels<Real>& kernels) {
        for (int i = 0; i < m_copies; ++i) {
            std::fill(m_w.begin(), m_w.end(), Real(1));
            std::fill(m_x.begin(), m_x.end(), Real(0));
            kernels.forward(panel(i), leading(), m_size.columns, leading(), m_w.data(), m_x.data());
            kernels.backward(panel(i), leading(), m_size.columns, leading(), m_w.data(), m_x.data());
        }
    }
    void factor(const Blas<Real>& blas) {
        const int rows = below(), n = leading(), nUpdate = updateLeading();
        const Real one = 1, minusOne = -1;
        for (int i = 0; i < m_copies; ++i) {
            Real *const top = panel(i), *const bottom = top + m_size.columns;
            int info = 0;
            blas.potrf("L", &m_size.columns, top, &n, &info);
            blas.trsm("R", "L", "T", "N", &rows, &m_size.columns, &one, top, &n, bottom, &n);
            blas.syrk("L", "N", &rows, &m_size.columns, &minusOne, bottom, &n, &one, m_update.data(),
                      &nUpdate);
        }
    }

  private:
    int leading() const { return dense::padded<Real>(m_size.rows); }
    int updateLeading() const { return dense::padded<Real>(below()); }
    std::size_t panelSize() const { return static_cast<std::size_t>(leading()) * m_size.columns; }
    Real* panel(int i) { return m_panels.data() + i * panelSize(); }

    FrontSize m_size;
    int m_copies;
    LargeArray<Real> m_original, m_panels, m_update;
    std::vector<Real> m_inverse, m_w, m_x;
};

template <class Real>
class KernelBench {
  public:
    KernelBench(FrontSize size, BenchRecorder& recorder)
        : m_fronts(size),
          m_recorder(recorder),
          m_name("front " + std::to_string(size.columns) + " x " + std::to_string(size.rows) +
                 (sizeof(Real) == 4 ? ", single, " : ", double, ")) {}

    void run() {
        const double blas = addBlas();
        for (const SimdTarget target : supportedSimdTargets()) addTarget(target, blas);
    }

  private:
    /// Returns Gflop/s, 0 without a BLAS.
    double addBlas() {
        const Blas<Real> blas;
        if (!blas.isThere()) return 0;
        const Timing time = timed([&] { m_fronts.factor(blas); }, [&] { m_fronts.restore(); });
        m_recorder.add({m_name + "BLAS", 1, time, {{"Gflop/s", rate(time)}}});
        return rate(time);
    }

    void addTarget(SimdTarget target, double blas) {
        setSimdTarget(target);
        const auto& kernels = dense::kernels<Real>();
        const Timing time = timed([&] { m_fronts.factor(kernels); }, [&] { m_fronts.restore(); });
        m_fronts.prepareSolves(kernels);
        const Timing solve = timed([&] { m_fronts.solve(kernels); });
        BenchRow row{m_name + std::string(nameOf(target)), 1, time, {{"Gflop/s", rate(time)}}};
        if (blas > 0) row.figures.push_back({"times the BLAS's speed", rate(time) / blas});
        row.figures.push_back({"solves (GB/s)", 1e-9 * m_fronts.solveBytes() / solve.processor});
        m_recorder.add(row);
    }

    double rate(const Timing& time) const { return 1e-9 * m_fronts.flops() / time.processor; }

    /// Measures the work on one front.
    Timing timed(const std::function<void()>& work, const std::function<void()>& prepare = {}) const {
        Timing time = measure(m_recorder.repeats(0.1), work, prepare);
        for (double* part : {&time.median, &time.minimum, &time.maximum, &time.processor})
            *part /= m_fronts.copies();
        return time;
    }

    Fronts<Real> m_fronts;
    BenchRecorder& m_recorder;
    std::string m_name;
};

}  // namespace

void addKernelRows(BenchRecorder& recorder) {
    const RestoredTarget restored;
    const Cholesky oneBlasThread;  // sets it
    for (const FrontSize size : kFronts) {
        KernelBench<float>(size, recorder).run();
        KernelBench<double>(size, recorder).run();
    }
}

}  // namespace wend
