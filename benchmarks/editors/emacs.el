;;; What Eglot shows of the file $TRIED, written to $ANSWERS as JSON.  -*- lexical-binding: t -*-
;; Its configuration is the snippet of editors/README.md, loaded before.

(require 'eglot)
(require 'flymake)
(require 'json)

(defconst tried-patience 60 "Seconds until a server that says nothing is given up.")

(defun tried-until (holds)
  "Wait until the function HOLDS returns something, and return it."
  (let ((end (+ (float-time) tried-patience)) found)
    (while (and (not (setq found (funcall holds))) (< (float-time) end))
      (accept-process-output nil 0.1))
    found))

(defun tried-shown ()
  "Rows of code and line, of what Flymake shows."
  (flymake-start)
  (mapcar (lambda (shown)
            (let ((text (flymake-diagnostic-text shown)))
              (list (and (string-match "[A-Z]\\{3\\}[0-9]\\{3\\}" text) (match-string 0 text))
                    (line-number-at-pos (flymake-diagnostic-beg shown)))))
          (flymake-diagnostics)))

(defun tried-hover ()
  "What the server says of the name at point."
  (let ((contents (plist-get (jsonrpc-request (eglot-current-server) :textDocument/hover
                                              (eglot--TextDocumentPositionParams))
                             :contents)))
    (plist-get contents :value)))

(defun tried-ends ()
  "Files that the definition of the name at point leads to."
  (mapcar (lambda (found)
            (xref-location-group (xref-item-location found)))
          (xref-backend-definitions 'eglot "LSP identifier at point.")))

(defun tried-renamed (name)
  "Names of the files with a change after the name at point has become NAME."
  (cl-letf (((symbol-function 'y-or-n-p) #'always))  ; until 1.9, Eglot asks where a file is not open yet
    (eglot-rename name))
  (delq nil (mapcar (lambda (buffer)
                      (with-current-buffer buffer
                        (and buffer-file-name
                             (save-excursion (goto-char (point-min)) (search-forward name nil t))
                             buffer-file-name)))
                    (buffer-list))))

(let ((eglot-confirm-server-initiated-edits nil)
      (eglot-confirm-server-edits nil)
      (eglot-sync-connect t))
  (find-file (getenv "TRIED"))
  (call-interactively #'eglot)
  (let* ((shown (tried-until #'tried-shown))
         (hover (progn
                  (goto-char (point-min))
                  (forward-line (1- (string-to-number (getenv "TRIED_LINE"))))
                  (forward-char (1- (string-to-number (getenv "TRIED_COLUMN"))))
                  (tried-hover)))
         (ends (tried-ends))
         (renamed (tried-renamed (getenv "NEW_NAME"))))
    (with-temp-file (getenv "ANSWERS")
      (insert (json-encode (list (cons 'shown (vconcat shown)) (cons 'hover hover)
                                 (cons 'ends (vconcat ends)) (cons 'renamed (vconcat renamed))))))))
(kill-emacs 0)
