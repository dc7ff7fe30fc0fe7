// Before anything is shown, and in words that any browser knows: the theme, and whether the script below can run.
(function () {
  var root = document.documentElement, theme = null;
  try { theme = localStorage.getItem("vpr-bench-theme"); } catch (refused) { /* then it is not remembered */ }
  if (theme !== "light" && theme !== "dark") {
    theme = window.matchMedia && matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  }
  root.setAttribute("data-theme", theme);
  if ("DecompressionStream" in window && "HTMLDialogElement" in window && "IntersectionObserver" in window) {
    root.className = "js";
  }
})();
