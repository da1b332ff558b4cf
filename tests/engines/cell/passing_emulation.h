/// @file
/// SPEs that are not quite what they seem, to see what engines make of it.
#pragma once

#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "engines/cell/emulation.h"

namespace cellsweep::cell {

/// Passes everything on.
class PassingEmulation : public Emulation {
 public:
  explicit PassingEmulation(std::shared_ptr<Emulation> all) : all_(std::move(all)) {}

  LocalStoreBudget local_store() const override { return all_->local_store(); }
  spe_program_handle_t& image(spe_program_handle_t& program) const override { return all_->image(program); }
  spe_context_ptr_t create_context(unsigned flags, unsigned spes) override {
    return all_->create_context(flags, spes);
  }
  SpeCounts counts(spe_context_ptr_t spe) const override { return all_->counts(spe); }
  SpeCycles cycles(spe_context_ptr_t spe) const override { return all_->cycles(spe); }
  std::string fault(spe_context_ptr_t spe) const override { return all_->fault(spe); }

 private:
  std::shared_ptr<Emulation> all_;
};

/// Gives out the first few contexts and then no more.
class FewSpes final : public PassingEmulation {
 public:
  FewSpes(std::shared_ptr<Emulation> all, int few) : PassingEmulation(std::move(all)), left_(few) {}

  spe_context_ptr_t create_context(unsigned flags, unsigned spes) override {
    return left_-- > 0 ? PassingEmulation::create_context(flags, spes) : nullptr;
  }

 private:
  int left_;
};

/// Promises twice the local store that there is.
class Boaster final : public PassingEmulation {
 public:
  using PassingEmulation::PassingEmulation;

  LocalStoreBudget local_store() const override {
    LocalStoreBudget budget = PassingEmulation::local_store();
    budget.limit *= 2;
    return budget;
  }
};

/// Loads another program than it is asked to.
class WrongProgram final : public PassingEmulation {
 public:
  WrongProgram(std::shared_ptr<Emulation> all, spe_program_handle_t& program)
      : PassingEmulation(std::move(all)), program_(program) {}

  spe_program_handle_t& image(spe_program_handle_t&) const override { return program_; }

 private:
  spe_program_handle_t& program_;
};

/// Knows the SPEs that it gave out.
class KnownSpes : public PassingEmulation {
 public:
  using PassingEmulation::PassingEmulation;

  spe_context_ptr_t create_context(unsigned flags, unsigned spes) override {
    contexts_.push_back(PassingEmulation::create_context(flags, spes));
    return contexts_.back();
  }

  spe_context_ptr_t context(std::size_t index) const { return contexts_[index]; }

 private:
  std::vector<spe_context_ptr_t> contexts_;
};

/// Finds no memory to say what a program broke.
class SpeechlessSpes final : public KnownSpes {
 public:
  using KnownSpes::KnownSpes;

  std::string fault(spe_context_ptr_t) const override { throw std::bad_alloc(); }
};

}  // namespace cellsweep::cell
