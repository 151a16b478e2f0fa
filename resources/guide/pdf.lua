-- What LaTeX needs of the guide and a browser does not: equations with their number at the right,
-- terms of the dictionary that are longer than a line, tables in a smaller size, one picture to a line.

-- The number of an equation stands behind it as a span; in LaTeX it is part of the formula.
function Div(div)
  if not div.classes:includes("equation") then return nil end
  return div:walk({
    Para = function(paragraph)
      local formula, number
      for _, part in ipairs(paragraph.content) do
        if part.t == "Math" then formula = part.text end
        if part.t == "Span" then number = pandoc.utils.stringify(part):match("%d+") end
      end
      if not (formula and number) then return nil end
      return pandoc.Para({pandoc.Math("DisplayMath", formula .. "\\tag{" .. number .. "}")})
    end
  })
end

-- A label of LaTeX's list does not break, so a term is a paragraph of its own.
function DefinitionList(list)
  local blocks = pandoc.List()
  for _, item in ipairs(list.content) do
    local term = pandoc.List(item[1])
    term:insert(pandoc.RawInline("latex", "\\nopagebreak"))
    blocks:insert(pandoc.Para(term))
    for _, definition in ipairs(item[2]) do blocks:insert(pandoc.BlockQuote(definition)) end
  end
  return blocks
end

function Table(rows)
  return {pandoc.RawBlock("latex", "\\begingroup\\small"), rows,
          pandoc.RawBlock("latex", "\\endgroup")}
end

-- Help of the program goes on below its own column where it is longer than a line of the page.
local WIDTH = 86
function CodeBlock(block)
  if not block.classes:includes("text") then return nil end
  local lines = pandoc.List()
  for line in (block.text .. "\n"):gmatch("([^\n]*)\n") do
    local column = #(line:match("^%s+%S.-%s%s%s*%f[%S]") or line:match("^%s*"))
    if column > 40 then column = 30 end
    -- What begins at the margin is a command and stays one line.
    while line:match("^%s") and utf8.len(line) > WIDTH do
      local head = line:sub(1, utf8.offset(line, WIDTH + 1) - 1):match("^(.+)%s")
      if not head or #head <= column then break end
      lines:insert(head)
      line = string.rep(" ", column) .. line:sub(#head + 1):gsub("^%s+", "")
    end
    lines:insert(line)
  end
  block.text = table.concat(lines, "\n")
  return block
end

-- LaTeX takes no SVG.
function Image(image)
  image.src = image.src:gsub("%.svg$", ".pdf")
  return image
end

-- Pictures side by side are wider together than the page.
function Para(paragraph)
  for index, part in ipairs(paragraph.content) do
    if part.t ~= "Image" and part.t ~= "Space" and part.t ~= "SoftBreak" then return nil end
    if part.t ~= "Image" then paragraph.content[index] = pandoc.LineBreak() end
  end
  return paragraph
end
