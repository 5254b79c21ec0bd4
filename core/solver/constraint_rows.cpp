#include "core/solver/constraint_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace wend {
namespace {

// Weights of a row of weights around 1 count as nothing below this, which is far above rounding and far below
// a real weight.
constexpr double kNothing = 1e-10;

/// A row on its way to echelon form: Σ weights · v = Σ values · prescribed.
struct WorkingRow {
    int row = -1;
    int pivot = -1;
    std::map<int, double> weights, values;

    void subtract(const WorkingRow& other, double factor) {
        for (const auto& [vertex, weight] : other.weights) weights[vertex] -= factor * weight;
        for (const auto& [row_, value] : other.values) values[row_] -= factor * value;
        weights.erase(other.pivot);  // zero but for rounding
    }
    void scale(double factor) {
        for (auto& [vertex, weight] : weights) weight *= factor;
        for (auto& [row_, value] : values) value *= factor;
    }
    int largest(const std::set<int>& without) const {
        int best = -1;
        double size = kNothing;
        for (const auto& [vertex, weight] : weights)
            if (std::abs(weight) > size && !without.contains(vertex)) {
                size = std::abs(weight);
                best = vertex;
            }
        return best;
    }
};

WorkingRow workingRow(const ConstraintRow& row, int index) {
    WorkingRow work;
    work.row = index;
    for (const auto& [vertex, weight] : row.terms)
        if (weight != 0) work.weights[vertex] += weight;
    work.values[index] = 1;
    return work;
}

std::vector<int> singleVertexRowsFirst(const std::vector<ConstraintRow>& rows) {
    std::vector<int> order;
    for (const bool single : {true, false})
        for (std::size_t i = 0; i < rows.size(); ++i)
            if ((rows[i].terms.size() == 1) == single) order.push_back(static_cast<int>(i));
    return order;
}

/// Returns the dependency of a row that has no weight left: 0 = Σ values · prescribed, with 1 for itself.
DependentRow dependencyOf(const WorkingRow& work) {
    DependentRow dependent{work.row, {}};
    for (const auto& [row, value] : work.values)
        if (row != work.row && value != 0) dependent.combination.emplace_back(row, -value);
    return dependent;
}

class Reducer {
  public:
    explicit Reducer(const Sliders& sliders) {
        for (const Slider& slider : sliders) m_sliding.insert(slider.vertex);
    }

    /// Reduces a row by the pivots so far. If nothing is left it is dependent, else it gets a pivot.
    void add(const ConstraintRow& row, int index) {
        WorkingRow work = workingRow(row, index);
        reduce(work);
        int pivot = work.weights.size() > 1 ? work.largest(m_sliding) : -1;
        if (pivot < 0) pivot = work.largest({});
        if (pivot < 0) {
            m_result.dependent.push_back(dependencyOf(work));
            return;
        }
        work.pivot = pivot;
        work.scale(1 / work.weights.at(pivot));
        work.weights[pivot] = 1;
        substituteInEarlier(work);
        m_rowOfPivot[pivot] = m_rows.size();
        for (const auto& [vertex, weight] : work.weights) m_users[vertex].push_back(m_rows.size());
        m_rows.push_back(std::move(work));
    }

    Elimination finish() {
        for (const auto& work : m_rows) {
            Elimination::Pivot pivot{work.pivot, work.row, {work.values.begin(), work.values.end()}, {}};
            for (const auto& [vertex, weight] : work.weights)
                if (vertex != work.pivot && weight != 0) pivot.free.emplace_back(vertex, weight);
            m_result.pivots.push_back(std::move(pivot));
        }
        return std::move(m_result);
    }

  private:
    /// Takes the pivots of earlier rows out; those are in reduced form, so none comes back.
    void reduce(WorkingRow& work) const {
        const auto before = work.weights;
        for (const auto& [vertex, weight] : before)
            if (const auto found = m_rowOfPivot.find(vertex); found != m_rowOfPivot.end())
                work.subtract(m_rows[found->second], weight);
    }
    /// Takes the new pivot out of the earlier rows that use it.
    void substituteInEarlier(const WorkingRow& work) {
        const auto users = m_users[work.pivot];
        for (std::size_t user : users) {
            auto& earlier = m_rows[user];
            const auto found = earlier.weights.find(work.pivot);
            if (found == earlier.weights.end()) continue;
            earlier.subtract(work, found->second);
            for (const auto& [vertex, weight] : work.weights) m_users[vertex].push_back(user);
        }
    }

    std::set<int> m_sliding;
    Elimination m_result;
    std::vector<WorkingRow> m_rows;
    std::map<int, std::size_t> m_rowOfPivot;
    std::map<int, std::vector<std::size_t>> m_users;  // rows that may have the vertex
};

}  // namespace

std::vector<ConstraintRow> simplified(const std::vector<ConstraintRow>& rows) {
    std::vector<ConstraintRow> result;
    for (const auto& row : rows) {
        std::map<int, double> weights;
        for (const auto& [vertex, weight] : row.terms) weights[vertex] += weight;
        std::erase_if(weights, [](const auto& term) { return term.second == 0; });
        result.push_back({{weights.begin(), weights.end()}});
    }
    return result;
}

Elimination eliminate(const std::vector<ConstraintRow>& rows, const Sliders& sliders) {
    Reducer reducer(sliders);
    for (int row : singleVertexRowsFirst(rows)) reducer.add(rows[row], row);
    return reducer.finish();
}

std::vector<DependentRow> dependentRows(const std::vector<ConstraintRow>& rows) {
    return eliminate(rows).dependent;
}

}  // namespace wend
