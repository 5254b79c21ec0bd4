#include "core/factor/cholesky.h"

#include <cholmod.h>
#include <dlfcn.h>
#if __has_include(<omp.h>)
#include <omp.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <new>

#include "core/base/abandonable.h"
#include "core/base/address_room.h"

namespace wend {
namespace {

void ignoreError(int, const char*, int, const char*) {}  // statuses are looked at where they arise

/// CHOLMOD opens parallel regions of a fixed four threads in small loops, which costs more than it gains; the
/// setting belongs to the calling thread and is given back.
class [[maybe_unused]] SerialOpenMp {
  public:
#if __has_include(<omp.h>)
    SerialOpenMp() : m_levels(omp_get_max_active_levels()) {
        omp_set_max_active_levels(0);
    }
    ~SerialOpenMp() {
        omp_set_max_active_levels(m_levels);
    }
#else
    SerialOpenMp() = default;
#endif
    SerialOpenMp(const SerialOpenMp&) = delete;
    SerialOpenMp& operator=(const SerialOpenMp&) = delete;

  private:
    [[maybe_unused]] int m_levels = 1;
};

/// Returns a function of the BLAS that CHOLMOD is linked with; null where that BLAS has none of this name.
template <class Function>
Function* blasFunction(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));  // NOLINT: the way of dlsym
}

/// Limits the BLAS to one thread, which makes it repeatable and is no slower on blocks of this size. The
/// reference BLAS has no such setting.
void useOneBlasThread() {
    static std::once_flag once;
    std::call_once(once, [] {
        if (auto* setThreads = blasFunction<void(int)>("openblas_set_num_threads")) setThreads(1);
    });
}

/// Makes the smallest call that makes OpenBLAS take its buffer: 0 = 0 · 0 · 0 + 0 · 0.
void callBlas() {
    using Syrk = void(const char*, const char*, const int*, const int*, const double*, const double*,
                      const int*, const double*, double*, const int*);
    const int one = 1;
    const double zero = 0;
    double sum = 0;
    if (auto* syrk = blasFunction<Syrk>("dsyrk_"))
        syrk("L", "N", &one, &one, &zero, &zero, &one, &zero, &sum, &one);
}

/// OpenBLAS takes a buffer for each thread that calls it at a time, keeps it, and where there are no
/// addresses for one asks for it for ever: so whether there are is looked at before it is called, and the
/// buffer is taken at once, before CHOLMOD or another thread takes the addresses.
class BlasBuffer {
  public:
    BlasBuffer() {
        if (++allUsers <= allKept) return;
        if (!hasAddressRoom(kRoom)) {
            --allUsers;
            throw std::bad_alloc();
        }
        callBlas();
    }
    ~BlasBuffer() {
        const int users = allUsers--;
        for (int kept = allKept; kept < users && !allKept.compare_exchange_weak(kept, users);) {
        }
    }
    BlasBuffer(const BlasBuffer&) = delete;
    BlasBuffer& operator=(const BlasBuffer&) = delete;

  private:
    static constexpr std::size_t kRoom = std::size_t{160}
                                         << 20;  // the buffer has 128 MB in Debian's OpenBLAS
    static inline std::atomic<int> allUsers = 0, allKept = 0;
};

std::mutex& analysisMutex() {
    static std::mutex mutex;
    return mutex;
}

bool allFinite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

struct Cholesky::Handles {
    cholmod_common common{};
    cholmod_sparse* matrix = nullptr;
    cholmod_factor* factor = nullptr;
    cholmod_dense *x = nullptr, *work1 = nullptr, *work2 = nullptr;

    Handles() {
        cholmod_start(&common);
        common.print = 0;
        common.error_handler = ignoreError;
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.final_ll = 1;
        common.quick_return_if_not_posdef = 1;
    }
    ~Handles() {
        release();
        cholmod_finish(&common);
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    void release() {
        cholmod_free_factor(&factor, &common);
        cholmod_free_sparse(&matrix, &common);
        cholmod_free_dense(&x, &common);
        cholmod_free_dense(&work1, &common);
        cholmod_free_dense(&work2, &common);
    }
    std::vector<int> orderBlocks();
    void analyze();
    void factorize();

    int blockSize = 1;
    Ordering ordering = Ordering::MinimumDegree;
};

/// Returns the fill-reducing order of the graph of blocks, which is a third of the work of the scalar graph.
/// It is nested dissection with METIS's cuts; CHOLMOD orders the parts and cuts by minimum degree, because
/// METIS's own order of a cut scatters what is added to its front, so that a factorization in the plane takes
/// a sixth longer.
std::vector<int> Cholesky::Handles::orderBlocks() {
    const auto* start = static_cast<const int*>(matrix->p);
    const auto* row = static_cast<const int*>(matrix->i);
    const std::size_t blocks = matrix->ncol / blockSize;
    cholmod_sparse* graph = cholmod_allocate_sparse(blocks, blocks, matrix->nzmax / blockSize, 1, 1, -1,
                                                    CHOLMOD_PATTERN, &common);
    if (graph == nullptr) throw std::bad_alloc();
    auto* graphStart = static_cast<int*>(graph->p);
    auto* graphRow = static_cast<int*>(graph->i);
    int count = 0;
    for (std::size_t q = 0; q < blocks; ++q) {
        graphStart[q] = count;
        for (int i = start[q * blockSize]; i < start[q * blockSize + 1]; i += blockSize)
            graphRow[count++] = row[i] / blockSize;
    }
    graphStart[blocks] = count;
    std::vector<int> order(blocks), parents(blocks), parts(blocks);
    if (ordering == Ordering::MinimumDegree)
        cholmod_amd(graph, nullptr, 0, order.data(), &common);
    else
        cholmod_nested_dissection(graph, nullptr, 0, order.data(), parents.data(), parts.data(), &common);
    cholmod_free_sparse(&graph, &common);
    return order;
}

/// Runs CHOLMOD's analysis with the order of the blocks, in which the unknowns of a block are consecutive.
void Cholesky::Handles::analyze() {
    const SerialOpenMp serial;
    const std::lock_guard lock(analysisMutex());
    std::vector<int> order;
    for (int block : orderBlocks())
        for (int k = 0; k < blockSize; ++k) order.push_back(block * blockSize + k);
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 1;
    factor = cholmod_analyze_p(matrix, order.data(), nullptr, 0, &common);
    if (factor == nullptr) throw std::bad_alloc();
}

void Cholesky::Handles::factorize() {
    const SerialOpenMp serial;
    const BlasBuffer buffer;
    common.status = CHOLMOD_OK;
    cholmod_factorize(matrix, factor, &common);
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
}

Cholesky::Cholesky() : m_handles(std::make_shared<Handles>()) {
    useOneBlasThread();
}
Cholesky::~Cholesky() = default;

/// Runs work so that a request to stop is answered at once. Work on a small matrix is not interrupted,
/// because it ends soon.
bool Cholesky::run(void (*work)(Handles&), const std::stop_token& stop) {
    constexpr std::size_t kSmall = 15000;
    const bool small = m_handles->matrix->ncol < kSmall;
    const auto whole = [work, handles = m_handles] { work(*handles); };
    if (runAbandonable(whole, small ? std::stop_token() : stop)) return true;
    m_handles = std::make_shared<Handles>();
    return false;
}

/// Takes a copy of the pattern, and runs the analysis so that a request to stop is answered at once.
bool Cholesky::analyze(const std::vector<int>& columnStart, const std::vector<int>& row, int blockSize,
                       Ordering ordering, const std::stop_token& stop) {
    auto& h = *m_handles;
    h.release();
    const std::size_t n = columnStart.size() - 1;
    h.matrix = cholmod_allocate_sparse(n, n, row.size(), 1, 1, -1, CHOLMOD_REAL, &h.common);
    if (h.matrix == nullptr) throw std::bad_alloc();
    std::copy(columnStart.begin(), columnStart.end(), static_cast<int*>(h.matrix->p));
    std::copy(row.begin(), row.end(), static_cast<int*>(h.matrix->i));
    std::fill_n(static_cast<double*>(h.matrix->x), row.size(), 0.0);
    h.blockSize = blockSize;
    h.ordering = ordering;
    return run([](Handles& handles) { handles.analyze(); }, stop);
}

bool Cholesky::isAnalyzed() const {
    return m_handles->factor != nullptr;
}

double Cholesky::factorFlops() const {
    return m_handles->common.fl;
}

double Cholesky::factorEntries() const {
    return m_handles->common.lnz;
}

double Cholesky::bytes() const {
    return sizeof(double) * static_cast<double>(m_handles->factor->xsize);
}

bool Cholesky::hasNumbers() const {
    return m_handles->factor->x != nullptr;
}

Supernodes Cholesky::supernodes() const {
    const cholmod_factor& f = *m_handles->factor;
    const auto ints = [](const void* data, std::size_t count) {
        const auto* first = static_cast<const int*>(data);
        return std::vector<int>(first, first + count);
    };
    return {ints(f.Perm, f.n), ints(f.super, f.nsuper + 1), ints(f.pi, f.nsuper + 1), ints(f.s, f.ssize)};
}

std::span<const int> Cholesky::columnStart() const {
    return {static_cast<const int*>(m_handles->matrix->p), m_handles->matrix->ncol + 1};
}

std::span<const int> Cholesky::row() const {
    return {static_cast<const int*>(m_handles->matrix->i), m_handles->matrix->nzmax};
}

std::span<double> Cholesky::values() {
    return {static_cast<double*>(m_handles->matrix->x), m_handles->matrix->nzmax};
}

// cholmod_factorize also returns TRUE if it stopped at a pivot ≤ 0, which only `minor` shows; NaN passes
// through all of it.
Cholesky::Status Cholesky::factorize(const std::stop_token& stop) {
    if (!allFinite(values())) return Status::NotFinite;
    if (!run([](Handles& handles) { handles.factorize(); }, stop)) return Status::Stopped;
    const auto& h = *m_handles;
    const bool good = h.common.status == CHOLMOD_OK && h.factor->minor == h.factor->n;
    return good ? Status::Done : Status::NotPositiveDefinite;
}

/// Solves on one thread, and checks that the result is finite.
Cholesky::Status Cholesky::solve(std::span<const double> b, std::span<double> x) {
    const SerialOpenMp serial;
    const BlasBuffer buffer;
    auto& h = *m_handles;
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = b.size();
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, h.factor, &right, nullptr, &h.x, nullptr, &h.work1, &h.work2, &h.common))
        throw std::bad_alloc();
    const std::span<const double> result{static_cast<const double*>(h.x->x), b.size()};
    if (!allFinite(result)) return Status::NotFinite;
    std::copy(result.begin(), result.end(), x.begin());
    return Status::Done;
}

}  // namespace wend
