// Explanations of why an answer cannot be read, with examples that can.
export const PROBLEMS = {
  empty: "Nothing is typed yet. Type a number or a list, for example 0.5 or [1, 2, 3].",
  long: "The text “{about}…” is too long: at most 1000 characters are read. Type a number or a list, for"
    + " example 0.5 or [1, 2, 3].",
  brackets: "The bracket “{about}” has no partner. Close each bracket with its own kind, for example [1, 2]"
    + " or (1 + 2)/3.",
  missing: "A number is missing at “{about}”. For example, type 1 + 2 or [1, 2, 3].",
  adjacent: "Something is missing between the numbers in “{about}”. Put a comma between the numbers of a"
    + " list, for example 1, 2, and * in a product, for example 2*pi. Put each row in brackets, for example"
    + " [[1, 2], [3, 4]].",
  parentheses: "The product in “{about}” can be read in two ways. Add parentheses: for example, 1/(2pi) or"
    + " (1/2)pi, and sqrt(2pi) or sqrt(2)*pi.",
  power: "Powers such as “{about}” cannot be read. Type a product, for example 3*3 for 3², or 1e-3 for 10⁻³.",
  function: "The function “{about}” cannot be read. Calculate it and type the result, for example 0.5 for"
    + " sin(30°).",
  unit: "The unit “{about}” cannot be read here. Type the number alone, for example 0.5, or with a unit that"
    + " fits: {units}.",
  units: "It is not clear which number in “{about}” has which unit. Put a unit after each number, for"
    + " example 1 m, 2 m, or after none. Of a sum, type the result.",
  equals: "The part “{about}” is not needed. Type only the number, for example 0.5 for v = 0.5.",
  list: "The calculation “{about}” has a list in it, which cannot be read. Calculate each number, for"
    + " example [2, 4] for 2*[1, 2].",
  zero: "The calculation “{about}” divides by zero, so it has no value. Type a number, for example 0.5.",
  root: "The calculation “{about}” takes the square root of a negative number, so it has no real value. An"
    + " example that has one: sqrt(2).",
  overflow: "The number in “{about}” is too large. Numbers up to 1e308 can be read.",
  unknown: "The part “{about}” cannot be read. Type a number or a list, for example 0.5, pi/2, sqrt(3)/2 or"
    + " [1, 2, 3].",
};
