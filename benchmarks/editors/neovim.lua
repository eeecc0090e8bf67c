-- What Neovim shows of the file $TRIED, written to $ANSWERS as JSON.  Its configuration is the snippet of editors/README.md.
local file, patience = vim.env.TRIED, 60000

local function leave(answers)
  vim.fn.writefile({ vim.fn.json_encode(answers) }, vim.env.ANSWERS)
  vim.cmd("qall!")
end

--- The first answer of a server, by name of the method; the position is where the tried name is.
local function ask(method, more)
  local position = { line = tonumber(vim.env.TRIED_LINE) - 1, character = tonumber(vim.env.TRIED_COLUMN) - 1 }
  local params = vim.tbl_extend("force", {
    textDocument = { uri = vim.uri_from_bufnr(0) },
    position = position,
  }, more or {})
  for _, answer in pairs(vim.lsp.buf_request_sync(0, method, params, patience) or {}) do
    return answer.result
  end
end

vim.cmd.edit(file)
local found = {}
vim.wait(patience, function()
  found = vim.diagnostic.get(0)
  return #found > 0
end, 50)
local answers = { shown = {}, ends = {}, renamed = {} }
for _, diagnostic in ipairs(found) do
  table.insert(answers.shown, { diagnostic.code, diagnostic.lnum + 1 })
end
local hover = ask("textDocument/hover")
answers.hover = hover and hover.contents.value or ""
for _, place in ipairs(ask("textDocument/definition") or {}) do
  table.insert(answers.ends, vim.uri_to_fname(place.targetUri or place.uri))
end

vim.fn.cursor(tonumber(vim.env.TRIED_LINE), tonumber(vim.env.TRIED_COLUMN))
vim.lsp.buf.rename(vim.env.NEW_NAME)
vim.wait(patience, function()
  return #vim.fn.getbufinfo({ bufmodified = 1 }) > 1
end, 50)
for _, buffer in ipairs(vim.fn.getbufinfo({ bufmodified = 1 })) do
  if vim.fn.match(vim.fn.getbufline(buffer.bufnr, 1, "$"), vim.env.NEW_NAME) >= 0 then
    table.insert(answers.renamed, buffer.name)
  end
end
leave(answers)
