#include "mfc/command.h"

#include <array>
#include <utility>

namespace spu_emu {

namespace {
constexpr std::array<std::pair<std::uint32_t, const char*>, 27> kNames{{
    {MFC_PUT_CMD, "put"},         {MFC_PUTB_CMD, "putb"},         {MFC_PUTF_CMD, "putf"},
    {MFC_PUTL_CMD, "putl"},       {MFC_PUTLB_CMD, "putlb"},       {MFC_PUTLF_CMD, "putlf"},
    {MFC_GET_CMD, "get"},         {MFC_GETB_CMD, "getb"},         {MFC_GETF_CMD, "getf"},
    {MFC_GETL_CMD, "getl"},       {MFC_GETLB_CMD, "getlb"},       {MFC_GETLF_CMD, "getlf"},
    {MFC_SDCRT_CMD, "sdcrt"},     {MFC_SDCRTST_CMD, "sdcrtst"},   {MFC_SDCRZ_CMD, "sdcrz"},
    {MFC_SDCRST_CMD, "sdcrst"},   {MFC_SDCRF_CMD, "sdcrf"},       {MFC_SNDSIG_CMD, "sndsig"},
    {MFC_SNDSIGB_CMD, "sndsigb"}, {MFC_SNDSIGF_CMD, "sndsigf"},   {MFC_PUTLLUC_CMD, "putlluc"},
    {MFC_PUTLLC_CMD, "putllc"},   {MFC_PUTQLLUC_CMD, "putqlluc"}, {MFC_BARRIER_CMD, "barrier"},
    {MFC_EIEIO_CMD, "eieio"},     {MFC_SYNC_CMD, "sync"},         {MFC_GETLLAR_CMD, "getllar"},
}};
}  // namespace

const char* command_name(std::uint32_t opcode) {
  for (const auto& [code, name] : kNames) {
    if (code == opcode) return name;
  }
  return "unknown";
}

}  // namespace spu_emu
